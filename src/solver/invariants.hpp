#pragma once
// What every accepted state obeys, checked after each step at small cost.

#include "mesh/topology.hpp"
#include "solver/controls.hpp"
#include "state/state.hpp"

namespace pfem {

/// Throws StepFailure in words, with place and node ids, when `next` (after the step from `last` and its remeshing)
///  - has a number that is not finite,
///  - has a fluid or solid cell that is not positive,
///  - has a fluid node that went through a rigid wall or through a solid,
///  - has gained or lost more than maxVolumeChange of the fluid's volume.
/// `topology`: that of `last`; walls may have moved.
template <int Dim>
void checkInvariants(const ConvergenceControls& controls, const Topology<Dim>& topology, const State<Dim>& last,
                     const State<Dim>& next);

/// Throws StepFailure when a node would cross its own mesh size within deltaTMin: no step could be small enough.
template <int Dim>
void checkSpeed(const ConvergenceControls& controls, const Nodes<Dim>& nodes);

}  // namespace pfem
