#include "picture/bands.hpp"

#include <algorithm>
#include <cmath>

namespace pfem {

namespace {

struct Corner {
    Vec<2> x;
    double f;
};
using Corners = std::vector<Corner>;

/// Where an edge has the value `level`; the same bits from both of its sides.
Corner cut(const Corner& a, const Corner& b, double level) {
    const Corner &low = a.f < b.f ? a : b, &high = a.f < b.f ? b : a;
    return {low.x + (level - low.f) / (high.f - low.f) * (high.x - low.x), level};
}

/// The part of a convex polygon below a level, and what lies above.
std::pair<Corners, Corners> partAt(double level, const Corners& polygon) {
    Corners below, above;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if (a.f <= level) below.push_back(a);
        if (a.f >= level) above.push_back(a);
        if ((a.f < level && b.f > level) || (a.f > level && b.f < level)) {
            const Corner c = cut(a, b, level);
            below.push_back(c);
            above.push_back(c);
        }
    }
    return {std::move(below), std::move(above)};
}

int bandAt(double f) { return static_cast<int>(std::clamp(std::floor(f * nBands), 0.0, nBands - 1.0)); }

}  // namespace

std::vector<std::vector<Polygon>> bandsOf(const std::vector<ShadedTriangle>& triangles) {
    std::vector<std::vector<Polygon>> bands(nBands);
    const auto add = [&](int band, const Corners& corners) {
        if (corners.size() < 3) return;
        Polygon polygon;
        for (const Corner& c : corners) polygon.push_back(c.x);
        bands[band].push_back(std::move(polygon));
    };
    for (const auto& [x, f] : triangles) {
        if (!std::isfinite(f[0] + f[1] + f[2]) || !(x[0] + x[1] + x[2]).allFinite()) continue;
        const auto [low, high] = std::minmax({f[0], f[1], f[2]});
        Corners rest{{x[0], f[0]}, {x[1], f[1]}, {x[2], f[2]}};
        for (int band = bandAt(low); band < bandAt(high); ++band) {
            auto [below, above] = partAt((band + 1.0) / nBands, rest);
            add(band, below);
            rest = std::move(above);
        }
        add(bandAt(high), rest);
    }
    return bands;
}

}  // namespace pfem
