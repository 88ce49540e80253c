#include "functions/pressureSensor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "functions/sensors.hpp"
#include "solver/setup.hpp"

namespace pfem {

namespace {

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
PressureSensor<Dim>::PressureSensor(const Dictionary& dict, const FunctionContext<Dim>& context)
    : dict_(dict), context_(context) {
    readEntries(dict, entries_);
    if (entries_.points.empty()) dict.fatal("points", "no sensor: points ((0.5 0 0) ...);");
    warnOutOfPlane<Dim>(dict, "points", entries_.points);
    if (Dim == 3 && entries_.shape != "disc") dict.fatal("shape", "in space a sensor is a disc");
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

#define PFEM_INSTANTIATE(D) template class PressureSensor<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
