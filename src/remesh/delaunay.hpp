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

/// `active`: the points that take part. `constraints`: faces that must appear; one that would cross an earlier
/// one is left out. Points that coincide with an earlier point are left out.
Triangulation<2> constrainedDelaunay(const Points<2>& points, const std::vector<int>& active,
                                     const std::vector<Face<2>>& constraints);

}  // namespace pfem
