#pragma once
// The Delaunay triangulation of points in space that have moved a little.

#include <optional>

#include "remesh/delaunay.hpp"

namespace pfem {

/// The same as spaceDelaunay, to the last cell. `last`: a triangulation of the points at other places; `now`: the
/// number that each of its points has now, ascending, -1: it has gone. Its cells whose spheres hold no other point stay
/// cells; beyond them cells are found one after the other; what is larger than `reach` [m] is triangulated from
/// nothing. None when points coincide, or when more than half of the cells have gone.
std::optional<Triangulation<3>> mendedDelaunay(const Points<3>& x, const std::vector<int>& active,
                                               const Triangulation<3>& last, const std::vector<int>& now, double reach);

}  // namespace pfem
