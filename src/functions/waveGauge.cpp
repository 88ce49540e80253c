#include "functions/waveGauge.hpp"

#include <algorithm>
#include <cmath>

#include "dictionary/function1.hpp"
#include "functions/sensors.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

using Stretch = std::pair<double, double>;  // along the gauge, low to high

/// The stretch of the line foot + s direction within a triangle; a line along an edge counts as inside.
std::optional<Stretch> cut(const std::array<Vec<2>, 3>& corners, const Vec<2>& foot, const Vec<2>& direction) {
    const Vec<2> normal(-direction[1], direction[0]);
    std::array<double, 3> off{}, along{};
    for (std::size_t k = 0; k < 3; ++k) {
        off[k] = (corners[k] - foot).dot(normal);
        along[k] = (corners[k] - foot).dot(direction);
    }
    const double size = std::max({std::abs(off[1] - off[0]), std::abs(off[2] - off[0]), std::abs(along[1] - along[0]),
                                  std::abs(along[2] - along[0])});
    for (double& d : off)
        if (std::abs(d) <= 1e-9 * size) d = 0;
    std::optional<Stretch> stretch;
    const auto include = [&](double s) {
        stretch = stretch ? Stretch{std::min(stretch->first, s), std::max(stretch->second, s)} : Stretch{s, s};
    };
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (off[k] == 0) include(along[k]);
        if (off[k] * off[next] < 0) include(along[k] + (along[next] - along[k]) * off[k] / (off[k] - off[next]));
    }
    return stretch;
}

/// The stretch within a tetrahedron, between its four planes N_k(s) = a + b s >= 0 with s from its middle; a line
/// along a face or an edge counts as inside.
std::optional<Stretch> cut(const std::array<Vec<3>, 4>& corners, const Vec<3>& foot, const Vec<3>& direction) {
    const Points<3> x(corners.begin(), corners.end());
    const auto geometry = simplexGeometry<3>(x, {0, 1, 2, 3});
    if (geometry.measure == 0) return {};
    const double middle = (simplexCentroid<3>(x, {0, 1, 2, 3}) - foot).dot(direction);
    double longest = 0;
    for (std::size_t k = 1; k < 4; ++k) longest = std::max(longest, (x[k] - x[0]).norm());
    Stretch stretch{-longest, longest};
    for (std::size_t k = 0; k < 4; ++k) {
        const double b = geometry.gradN[k].dot(direction);
        const double a = geometry.gradN[k].dot(foot + middle * direction - x[(k + 1) % 4]);
        if (std::abs(b) * longest < 1e-9) {
            if (a < -1e-9) return {};
        } else if (b > 0) {
            stretch.first = std::max(stretch.first, -a / b);
        } else {
            stretch.second = std::min(stretch.second, -a / b);
        }
    }
    if (!(stretch.first < stretch.second)) return {};
    return Stretch{middle + stretch.first, middle + stretch.second};
}

/// Two directions across the gauge, in 2D one.
template <int Dim>
std::vector<Vec<Dim>> across(const Vec<Dim>& direction) {
    if constexpr (Dim == 2) {
        return {Vec<2>(-direction[1], direction[0])};
    } else {
        const Vec<3> first = direction.unitOrthogonal();
        return {first, direction.cross(first)};
    }
}

/// On which sides of the line the nodes are, two bits for each direction across it; none: on the line, to 1e-6 of the
/// farthest node's distance.
template <int Dim>
std::vector<unsigned char> sidesOf(const Points<Dim>& x, const Vec<Dim>& foot, const Vec<Dim>& direction) {
    std::vector<unsigned char> side(x.size(), 0);
    unsigned char left = 1;
    for (const Vec<Dim>& normal : across<Dim>(direction)) {
        std::vector<double> off;
        double farthest = 0;
        for (const auto& place : x) {
            off.push_back((place - foot).dot(normal));
            farthest = std::max(farthest, std::abs(off.back()));
        }
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (off[i] > 1e-6 * farthest) side[i] = static_cast<unsigned char>(side[i] | left);
            if (off[i] < -1e-6 * farthest) side[i] = static_cast<unsigned char>(side[i] | 2 * left);
        }
        left = 4;
    }
    return side;
}

}  // namespace

Vec<3> upwards(const std::filesystem::path& root) {
    const auto g = readFunction1<Eigen::Vector3d>(Dictionary::read(root / "constant" / "g"), "value")->value(0);
    return g.norm() > 0 ? Vec<3>(-g) : Vec<3>(0, 0, 1);
}

template <int Dim>
std::optional<GaugeReading> readGauge(const State<Dim>& state, const Vec<Dim>& foot, const Vec<Dim>& direction) {
    std::vector<Stretch> stretches;
    const auto side = sidesOf<Dim>(state.nodes.x, foot, direction);
    for (const auto& cell : state.mesh.fluid.nodes) {
        unsigned char common = 255;
        for (const int node : cell) common = static_cast<unsigned char>(common & side[node]);
        if (common != 0) continue;
        std::array<Vec<Dim>, Dim + 1> corners;
        for (std::size_t k = 0; k <= Dim; ++k) corners[k] = state.nodes.x[cell[k]];
        if (const auto stretch = cut(corners, foot, direction)) stretches.push_back(*stretch);
    }
    if (stretches.empty()) return {};
    std::sort(stretches.begin(), stretches.end());
    GaugeReading reading;
    const double gap = 1e-9 * (stretches.back().second - stretches.front().first);
    double top = stretches.front().first;
    bool lowest = true;
    reading.highest = top;
    for (const auto& [low, high] : stretches) {
        if (low > top + gap) lowest = false;
        reading.depth += std::max(0.0, high - std::max(low, top));
        top = std::max(top, high);
        if (lowest) reading.elevation = top;
    }
    reading.highest = top;
    return reading;
}

template <int Dim>
WaveGauge<Dim>::WaveGauge(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    readEntries(dict, entries_);
    if (Dim == 3 && !dict.found("direction")) entries_.direction = upwards(context.root);
    if (entries_.points.empty()) dict.fatal("points", "no gauge: points ((0.5 0 0) ...);");
    if (!(entries_.direction.template head<Dim>().norm() > 0)) dict.fatal("direction", "the direction has no length");
    if (Dim == 2) demandPlane(dict, "direction", entries_.direction[2]);
    warnOutOfPlane<Dim>(dict, "points", entries_.points);
    entries_.direction.normalize();
}

template <int Dim>
void WaveGauge<Dim>::start(const State<Dim>&) {
    tables_.clear();
    for (const char* file : {"elevation", "highest", "depth"})
        tables_.push_back(sensorTable(context_, file, "Gauge", entries_.points));
}

template <int Dim>
void WaveGauge<Dim>::execute(const State<Dim>& state) {
    std::vector<double> elevation, highest, depth;
    for (const auto& point : entries_.points) {
        const auto reading = readGauge<Dim>(state, point.head<Dim>(), entries_.direction.head<Dim>().normalized());
        elevation.push_back(reading ? reading->elevation : dry);
        highest.push_back(reading ? reading->highest : dry);
        depth.push_back(reading ? reading->depth : dry);
    }
    sensorRow(tables_[0], state.time.value, elevation);
    sensorRow(tables_[1], state.time.value, highest);
    sensorRow(tables_[2], state.time.value, depth);
}

#define PFEM_INSTANTIATE(D)                                                                           \
    template std::optional<GaugeReading> readGauge<D>(const State<D>&, const Vec<D>&, const Vec<D>&); \
    template class WaveGauge<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
