#pragma once
// What every accepted state obeys, checked after each step at small cost.

#include <limits>

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

/// The speed that no node may exceed after landing, contacts and remeshing: that of the fastest now, after the
/// equations, and twice that of the fastest wall, solid or node of an opening: one may land on it, and be struck there.
template <int Dim>
double allowedSpeed(const Topology<Dim>& topology, const Nodes<Dim>& nodes);

/// Throws StepFailure when a node is faster than `allowed`, by more than round-off. Landing, contacts
/// (solver/impact.hpp) and new nodes keep to it by their formulas: no try is rejected but by a mistake in one of them.
/// Nodes from the id `firstNew` on are not looked at: an inlet may lay them into calm water.
template <int Dim>
void checkSpeedGain(double allowed, const Nodes<Dim>& nodes, Id firstNew = std::numeric_limits<Id>::max());

/// Throws StepFailure when a node would cross its own mesh size within deltaTMin: no step could be small enough.
template <int Dim>
void checkSpeed(const ConvergenceControls& controls, const Nodes<Dim>& nodes);

}  // namespace pfem
