#pragma once
// The Delaunay triangulation of points in space by ranks, each of which triangulates its own part of them.

#include <optional>

#include "parallel/ranks.hpp"
#include "remesh/delaunay.hpp"

namespace pfem {

/// The same as spaceDelaunay, to the last cell. Each rank triangulates the points of its part and those within `halo`
/// [m] of it; what no rank can prove (large cells; they are few when the halo is twice the largest circumradius of
/// fluid) is triangulated by all. All ranks have all points and get all cells.
Triangulation<3> sharedDelaunay(const Points<3>& x, const std::vector<int>& active, const Ranks& ranks, double halo);

/// The same by threads of this process, each of which triangulates a part. None when points coincide.
std::optional<Triangulation<3>> threadedDelaunay(const Points<3>& x, const std::vector<int>& active, int nThreads,
                                                 double halo);

/// The whole triangulation from those of its cells that are known, in Triangulator's order, with those of their
/// neighbours that are (-1: not known, or none): what is missing is between points that not only known cells surround,
/// and is found in the triangulation of those alone. None when it does not fit, which happens when points coincide.
std::optional<Triangulation<3>> completed(const Points<3>& x, const std::vector<int>& active, Triangulation<3> known);

}  // namespace pfem
