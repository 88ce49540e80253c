#pragma once
// Triangles with values, cut into bands of one colour each.

#include <array>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// Corners [pixels] and the values there as fractions of a scale; they may lie beyond 0 and 1.
struct ShadedTriangle {
    std::array<Vec<2>, 3> corners;
    std::array<double, 3> fractions;
};

inline constexpr int nBands = 256;

/// The middle of a band, as a fraction of the scale.
constexpr double bandFraction(int band) { return (band + 0.5) / nBands; }

using Polygon = std::vector<Vec<2>>;

/// The parts of the triangles in each of nBands equal bands of the scale; what lies beyond its ends is in the first and
/// the last one. Neighbours get the same points on their common edge. Triangles with values that are not finite are
/// left out.
std::vector<std::vector<Polygon>> bandsOf(const std::vector<ShadedTriangle>& triangles);

}  // namespace pfem
