#pragma once
// What a step begins with: who is joined to whom, and velocities that walls and clamps allow.

#include "conditions/problem.hpp"

namespace pfem {

/// Constraints between two times [s] counted from the state's.
template <int Dim>
NodeConstraints<Dim> constraintsOver(double from, double to, const Problem<Dim>& problem, const State<Dim>& state,
                                     const Topology<Dim>& topology);

/// The topology for a step and velocities that its start allows.
template <int Dim>
Topology<Dim> beginStep(const Problem<Dim>& problem, State<Dim>& state);

}  // namespace pfem
