#pragma once
// How the fluid of a new case becomes one with itself at periodic sides.

#include "conditions/problem.hpp"
#include "remesh/controls.hpp"

namespace pfem {

/// The fluid as it was meshed has nodes at both sides. Those at the upper ones go; cells reach the images of the nodes
/// at the lower ones instead. The ledger stays as it is.
template <int Dim>
State<Dim> joinedAtSides(const Problem<Dim>& problem, const RemeshingControls& controls, const State<Dim>& state);

}  // namespace pfem
