#pragma once
// No fluid node may leave its container or enter a solid.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Nodes whose path from xOld crossed a wall or that lie in a solid are put back to `distance` h off the surface,
/// and their velocity towards it (relative to the surface) is removed. Returns their number; the volume's change
/// is added to state.ledger["returned"].
template <int Dim>
int returnPenetrating(const Topology<Dim>& topology, const std::vector<PatchKind>& kinds,
                      const Points<Dim>& xOld, double distance, State<Dim>& state);

}  // namespace pfem
