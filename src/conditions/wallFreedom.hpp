#pragma once
// What walls leave a node of the fluid.

#include "conditions/freedom.hpp"
#include "mesh/wallFaces.hpp"

namespace pfem {

/// Directions along all the walls that hold a node (slip), with their normals where their points are at x.
template <int Dim>
Freedom<Dim> freedomOn(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x, const Supports<Dim>& supports) {
    Freedom<Dim> free;
    for (const int wall : supports)
        if (wall >= 0) free = free.without(inwardNormal<Dim>(x, walls[wall].nodes));
    return free;
}

}  // namespace pfem
