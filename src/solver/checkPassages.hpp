#pragma once
// Nothing goes through walls and solids within a step.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Throws StepFailure, with place and node, where between `last` and `next` a node of the fluid went through a rigid
/// wall or a solid, or one of a solid through a wall. `topology`: that of `last`; walls may have moved.
template <int Dim>
void checkPassages(const Topology<Dim>& topology, const State<Dim>& last, const State<Dim>& next);

}  // namespace pfem
