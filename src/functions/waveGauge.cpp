#include "functions/waveGauge.hpp"

#include <algorithm>
#include <cmath>

#include "dictionary/function1.hpp"
#include "functions/sensors.hpp"

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

}  // namespace

template <int Dim>
std::optional<GaugeReading> readGauge(const State<Dim>& state, const Vec<Dim>& foot, const Vec<Dim>& direction) {
    std::vector<Stretch> stretches;
    const Vec<Dim> normal(-direction[1], direction[0]);
    std::vector<double> off;
    double farthest = 0;
    for (const auto& x : state.nodes.x) {
        off.push_back((x - foot).dot(normal));
        farthest = std::max(farthest, std::abs(off.back()));
    }
    std::vector<unsigned char> side;  // 1: on the left, 2: on the right, 0: on the line
    for (const double d : off)
        side.push_back(static_cast<unsigned char>((d > 1e-6 * farthest ? 1 : 0) + (d < -1e-6 * farthest ? 2 : 0)));
    for (const auto& cell : state.mesh.fluid.nodes) {
        if ((side[cell[0]] & side[cell[1]] & side[cell[2]]) != 0) continue;
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

template std::optional<GaugeReading> readGauge<2>(const State<2>&, const Vec<2>&, const Vec<2>&);
template class WaveGauge<2>;

}  // namespace pfem
