#pragma once
// Constrained Delaunay triangulation of a polygon (the only place of the mesher that knows CGAL).

#include "base/types.hpp"

namespace pfem {

/// Triangles (counter-clockwise) of the region enclosed by `edges` (closed loops of point indices; a
/// loop inside another cuts a hole), with all `points` as corners. No edge of `edges` is divided.
/// Throws InternalError when edges cross or points coincide.
std::vector<Simplex<2>> triangulate(const Points<2>& points, const std::vector<Face<2>>& edges);

}  // namespace pfem
