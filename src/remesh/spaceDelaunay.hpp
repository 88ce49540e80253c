#pragma once
// Delaunay triangulations of points in space, from nothing.

#include <vector>

#include "base/types.hpp"

namespace pfem {

template <int Dim>
struct Triangulation;

/// Of the points that `active` names; the cells in the order that Triangulator promises. Empty when all are in a
/// plane. `coincide`: set when some are at the same place, of which one stands for all.
Triangulation<3> spaceDelaunay(const Points<3>& points, const std::vector<int>& active, bool* coincide = nullptr);

}  // namespace pfem
