#include "functions/pressureSensor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "functions/sensors.hpp"
#include "functions/wetFaces.hpp"
#include "mesh/distance.hpp"
#include "solver/setup.hpp"

namespace pfem {

namespace {

/// Antiderivatives of the weight w(s) and of s w(s); w integrates to 1 over the sensor, |s| <= R.
struct Weight {
    double R;
    bool disc;

    double zeroth(double s) const {
        if (!disc) return s / (2 * R);
        return (s * std::sqrt(std::max(0.0, R * R - s * s)) + R * R * std::asin(std::clamp(s / R, -1.0, 1.0))) /
               (M_PI * R * R);
    }
    double first(double s) const {
        if (!disc) return s * s / (4 * R);
        return -2 / (3 * M_PI * R * R) * std::pow(std::max(0.0, R * R - s * s), 1.5);
    }
};

}  // namespace

template <int Dim>
std::pair<SensorAnchor<Dim>, double> fixSensor(const State<Dim>& initial, const std::vector<PatchKind>& kinds,
                                               const Vec<Dim>& point) {
    std::pair<SensorAnchor<Dim>, double> best{{}, std::numeric_limits<double>::infinity()};
    const auto consider = [&](const Face<Dim>& face, const Points<Dim>& x, bool onSolid) {
        const double w = nearestWeight<Dim>(x[face[0]], x[face[1]], point);
        const double distance = ((1 - w) * x[face[0]] + w * x[face[1]] - point).norm();
        if (distance >= best.second) return;
        best = {{{initial.nodes.id[face[0]], initial.nodes.id[face[1]]}, {1 - w, w}, onSolid}, distance};
    };
    for (std::size_t k = 0; k < initial.mesh.patches.size(); ++k)
        if (isWall(kinds[k]))
            for (const auto& face : initial.mesh.patches[k].faces) consider(face, initial.nodes.x, false);
    const auto& solid = initial.mesh.solid.nodes;
    for (const auto& face : boundaryFaces<Dim>(solid, nodeToCells<Dim>(solid, initial.nodes.size())))
        consider(face.nodes, initial.nodes.X, true);
    return best;
}

namespace {

/// The face that a sensor is fixed to, and its centre.
template <int Dim>
std::pair<Face<Dim>, Vec<Dim>> placeOf(const SensorAnchor<Dim>& anchor, const Nodes<Dim>& nodes) {
    Face<Dim> face{};
    Vec<Dim> centre = Vec<Dim>::Zero();
    for (std::size_t k = 0; k < Dim; ++k) {
        face[k] =
            static_cast<int>(std::lower_bound(nodes.id.begin(), nodes.id.end(), anchor.ids[k]) - nodes.id.begin());
        centre += anchor.weights[static_cast<Eigen::Index>(k)] * nodes.x[face[k]];
    }
    return {face, centre};
}

/// The topology with those fluid cells alone that can have a face within `radius` of one of the places.
template <int Dim>
Topology<Dim> topologyAround(const State<Dim>& state, const std::vector<PatchKind>& kinds, const Points<Dim>& places,
                             double radius) {
    Mesh<Dim> near;
    near.solid = state.mesh.solid;
    near.patches = state.mesh.patches;
    const auto& x = state.nodes.x;
    for (const auto& cell : state.mesh.fluid.nodes) {
        double squared = 0;
        for (std::size_t k = 1; k <= Dim; ++k) squared = std::max(squared, (x[cell[k]] - x[cell[0]]).squaredNorm());
        const double reach = radius + 2 * std::sqrt(squared);
        if (std::any_of(places.begin(), places.end(),
                        [&](const Vec<Dim>& place) { return (x[cell[0]] - place).squaredNorm() < reach * reach; }))
            near.fluid.nodes.push_back(cell);
    }
    return makeTopology<Dim>(near, kinds, state.nodes.x, state.nodes.wall);
}

}  // namespace

template <int Dim>
SensorReading readSensor(const State<Dim>& state, const Topology<Dim>& topology, const SensorAnchor<Dim>& anchor,
                         double width, bool disc) {
    const auto& nodes = state.nodes;
    const auto [face, centre] = placeOf<Dim>(anchor, nodes);
    // out of the fluid: walls have it on their left, solids have themselves on the left
    const Vec<Dim> normal = (anchor.onSolid ? -1 : 1) * faceArea<Dim>(nodes.x, face).normalized();
    const Vec<Dim> along(-normal[1], normal[0]);
    const Weight weight{0.5 * width, disc};
    SensorReading reading;
    for (const auto& wet : wetFaces<Dim>(state, topology)) {
        if ((wet.solid >= 0) != anchor.onSolid) continue;
        const Vec<Dim> a = nodes.x[wet.nodes[0]] - centre, b = nodes.x[wet.nodes[1]] - centre;
        const double sa = a.dot(along), sb = b.dot(along);
        const double low = std::max(std::min(sa, sb), -weight.R), high = std::min(std::max(sa, sb), weight.R);
        if (!(low < high) || faceArea<Dim>(nodes.x, wet.nodes).normalized().dot(normal) < 0.7) continue;
        const auto at = [&](double s, double fa, double fb) { return fa + (fb - fa) * (s - sa) / (sb - sa); };
        const double height = at(0.5 * (low + high), a.dot(normal), b.dot(normal));
        if (std::abs(height) > weight.R) continue;  // of another wall
        const double slope = (nodes.p[wet.nodes[1]] - nodes.p[wet.nodes[0]]) / (sb - sa);
        const double p0 = nodes.p[wet.nodes[0]] - slope * sa;
        const double part = weight.zeroth(high) - weight.zeroth(low);
        reading.wet += part;
        reading.p += p0 * part + slope * (weight.first(high) - weight.first(low));
    }
    return reading;
}

template <int Dim>
PressureSensor<Dim>::PressureSensor(const Dictionary& dict, const FunctionContext<Dim>& context)
    : dict_(dict), context_(context) {
    readEntries(dict, entries_);
    if (entries_.points.empty()) dict.fatal("points", "no sensor: points ((0.5 0 0) ...);");
    warnOutOfPlane<Dim>(dict, "points", entries_.points);
}

template <int Dim>
void PressureSensor<Dim>::start(const State<Dim>& state) {
    const State<Dim> initial = initialState(context_.root, state);
    kinds_ = readProblem<Dim>(Case(context_.root), initial, nullptr).conditions.kind;
    anchors_.clear();
    for (const auto& point : entries_.points) {
        const auto [anchor, distance] = fixSensor<Dim>(initial, kinds_, point.head<Dim>());
        if (!(distance <= entries_.width))
            dict_.fatal("points",
                        std::isfinite(distance)
                            ? fmt::format("the sensor at ({} {} {}) is {:.3g} m away from the nearest wall or solid",
                                          point[0], point[1], point[2], distance)
                            : "there is neither a wall nor a solid that sensors could be fixed to");
        anchors_.push_back(anchor);
    }
    filters_.assign(anchors_.size(), TimeFilter(entries_.filter, entries_.filterTime));
    if (const auto found = state.memory.find(context_.name); found != state.memory.end()) recall(found->second);
    p_ = sensorTable(context_, "p", "Sensor", entries_.points);
    wet_ = sensorTable(context_, "wet", "Sensor", entries_.points);
    if (entries_.filter != "none") filtered_ = sensorTable(context_, "pFiltered", "Sensor", entries_.points);
}

template <int Dim>
void PressureSensor<Dim>::advance(const State<Dim>& state) {
    Points<Dim> places;
    for (const auto& anchor : anchors_) places.push_back(placeOf<Dim>(anchor, state.nodes).second);
    const auto topology = topologyAround<Dim>(state, kinds_, places, entries_.width);
    readings_.clear();
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
        readings_.push_back(readSensor<Dim>(state, topology, anchors_[i], entries_.width, entries_.shape == "disc"));
        filters_[i].advance(state.time.value, readings_[i].p);
    }
}

template <int Dim>
void PressureSensor<Dim>::execute(const State<Dim>& state) {
    std::vector<double> p, wet, filtered;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
        p.push_back(readings_[i].wet > 0 ? readings_[i].p : dry);
        wet.push_back(readings_[i].wet);
        filtered.push_back(filters_[i].value());
    }
    sensorRow(*p_, state.time.value, p);
    sensorRow(*wet_, state.time.value, wet);
    if (filtered_) sensorRow(*filtered_, state.time.value, filtered);
}

/// Per sensor: how many numbers, then its filter's numbers.
template <int Dim>
std::vector<double> PressureSensor<Dim>::memory() const {
    std::vector<double> all;
    if (entries_.filter == "none") return all;
    for (const auto& filter : filters_) {
        const auto numbers = filter.memory();
        all.push_back(static_cast<double>(numbers.size()));
        all.insert(all.end(), numbers.begin(), numbers.end());
    }
    return all;
}

/// Of another number of sensors or another filter nothing is kept.
template <int Dim>
void PressureSensor<Dim>::recall(const std::vector<double>& memory) {
    std::size_t at = 0;
    for (auto& filter : filters_) {
        const double wanted = at < memory.size() ? memory[at] : 0;
        if (!(wanted >= 1 && wanted < static_cast<double>(memory.size() - at))) return;
        const auto count = static_cast<std::size_t>(wanted);
        const auto begin = memory.begin() + static_cast<std::ptrdiff_t>(at) + 1;
        filter.recall({begin, begin + static_cast<std::ptrdiff_t>(count)});
        at += 1 + count;
    }
}

template std::pair<SensorAnchor<2>, double> fixSensor<2>(const State<2>&, const std::vector<PatchKind>&, const Vec<2>&);
template SensorReading readSensor<2>(const State<2>&, const Topology<2>&, const SensorAnchor<2>&, double, bool);
template class PressureSensor<2>;

}  // namespace pfem
