#pragma once
// No fluid node may be inside a solid.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Nodes that lie in a solid are put back to `distance` h off its surface, and their velocity towards it (relative
/// to the surface) is removed. Returns their number.
template <int Dim>
int returnPenetrating(const Topology<Dim>& topology, double distance, State<Dim>& state);

}  // namespace pfem
