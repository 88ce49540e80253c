#pragma once
// No fluid node may be inside a solid.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Nodes that have been put back.
struct Returned {
    int number = 0;
    std::vector<int> behind;  // (3D) those that have come through a face under water, between its nodes
};

/// Nodes that lie in a solid are put back to `distance` h off its surface, and their velocity towards it (relative
/// to the surface) is removed. In space a face of the solid is no constraint of the triangulation: where a node comes
/// so near that the face is none of its faces, no pressure holds the node any more, and it would come through in each
/// step. Cells that it shares with the face's nodes tell it from one that arrives.
template <int Dim>
Returned returnPenetrating(const Topology<Dim>& topology, double distance, State<Dim>& state);

}  // namespace pfem
