#pragma once
// What a step begins with: who is joined to whom, and velocities that walls and clamps allow.

#include "conditions/problem.hpp"

namespace pfem {

/// Constraints between two times [s] counted from the state's.
template <int Dim>
NodeConstraints<Dim> constraintsOver(double from, double to, const Problem<Dim>& problem, const State<Dim>& state,
                                     const Topology<Dim>& topology);

template <int Dim>
struct StepStart {
    Topology<Dim> topology;
    NodeConstraints<Dim> constraints;  // over the step
};

/// What a step of length dt [s] is about; the state gets velocities that its start allows. By ranks
/// that share the work.
template <int Dim>
StepStart<Dim> beginStep(const Problem<Dim>& problem, double dt, State<Dim>& state, const Ranks& ranks = {});

}  // namespace pfem
