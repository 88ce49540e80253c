#pragma once
// Nodes of the fluid take the mesh size of the place where they are.

#include "mesh/topology.hpp"
#include "state/images.hpp"

namespace pfem {

/// h of the fluid's nodes: the least of what the places of state.sizes and the surfaces of solids (with the sizes of
/// their nodes) ask for, growing by sizeGrowth per distance, and of the coarsest. Nodes of solids keep theirs. What is
/// beyond a periodic side counts from there.
template <int Dim>
void holdSizes(const Topology<Dim>& topology, const Period<Dim>& period, State<Dim>& state);

}  // namespace pfem
