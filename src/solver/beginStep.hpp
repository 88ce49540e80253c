#pragma once
// What a step begins with: who is joined to whom, and velocities that walls and clamps allow.

#include "conditions/problem.hpp"

namespace pfem {

/// Constraints between two times [s] counted from the state's.
template <int Dim>
NodeConstraints<Dim> constraintsOver(double from, double to, const Problem<Dim>& problem, const State<Dim>& state,
                                     const Topology<Dim>& topology);

/// The topology for a step of length dt and velocities that its start allows. Walls that lift off leave their water.
template <int Dim>
Topology<Dim> beginStep(const Problem<Dim>& problem, double dt, State<Dim>& state);

}  // namespace pfem
