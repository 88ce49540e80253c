#pragma once
// What one rank knows of a Delaunay triangulation of which it sees a part.

#include "parallel/bisection.hpp"
#include "remesh/delaunay.hpp"

namespace pfem {

/// Is the sphere through the nodes of a tetrahedron within the region, whatever the round-off?
bool sphereIsWithin(const Points<3>& x, const Simplex<3>& cell, const Region<3>& region);

struct ProvenCells : Triangulation<3> {  // neighbours among themselves; -1: another part's, or none
    bool coincide = false;               // points that the rank sees are at the same place
};

/// The rank sees the points within `halo` of its part's region. A cell of their triangulation is one of all points,
/// too, when its sphere lies within what the rank sees: no other point can be in it. Those whose first node is the
/// part's own are the part's.
ProvenCells provenCells(const Points<3>& x, const std::vector<int>& active, const Bisection<3>& parts, int part,
                        double halo);

}  // namespace pfem
