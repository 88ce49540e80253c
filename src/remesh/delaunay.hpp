#pragma once
// Constrained Delaunay triangulation of a point set.

#include <vector>

#include "base/types.hpp"

namespace pfem {

template <int Dim>
struct Triangulation {
    std::vector<Simplex<Dim>> cells;                   // positively oriented, all of the convex hull
    std::vector<std::array<int, Dim + 1>> neighbours;  // opposite to local node k; -1 outside the hull
};

/// `active`: the points that take part; of points that coincide one stands for all, in cells and in faces.
/// `fixed`: faces that must appear (walls, solids). `wished`: faces that appear unless they would cross a fixed or
/// an earlier one (free surface).
/// Throws StepFailure when fixed faces cross each other.
Triangulation<2> constrainedDelaunay(const Points<2>& points, const std::vector<int>& active,
                                     const std::vector<Face<2>>& fixed, const std::vector<Face<2>>& wished);

}  // namespace pfem
