#pragma once
// One accepted time step: Algorithm 1 and new connectivity, with rejection and repetition.

#include "remesh/remesh.hpp"
#include "solver/fsiStep.hpp"

namespace pfem {

struct AdvanceReport {
    StepReport step;
    NodeChanges mesh;
    double dt = 0;                     // the step that was accepted [s]
    int rejected = 0;                  // tries that were not
    int returned = 0;                  // nodes put back out of solids
    std::vector<std::string> reasons;  // of the rejections
    double seconds[2] = {0, 0};        // wall time of the step and of the remeshing
};

/// Advance `state` by dt or, after rejected tries, by dt/2, dt/4, ...; state.time is left to the caller.
/// Fluid volume by cause is added to state.ledger. A try counts when it obeys solver/invariants.hpp. Throws FailedStep
/// (or another StepFailure) after maxHalvings or below deltaTMin; the state is then the last good one.
/// `triangulator`: keeps the triangulation for the next step, which gives the same as one from nothing.
template <int Dim>
AdvanceReport advance(const Problem<Dim>& problem, const Controls& controls, Triangulator& triangulator,
                      State<Dim>& state, double dt);

/// The same with every triangulation from nothing.
template <int Dim>
AdvanceReport advance(const Problem<Dim>& problem, const Controls& controls, State<Dim>& state, double dt) {
    Triangulator triangulator;
    return advance<Dim>(problem, controls, triangulator, state, dt);
}

/// p and a at the very start of a run that agree with the forces, and v that is free of divergence. Throws FailedStep
/// where they cannot be found.
template <int Dim>
void startConsistently(const Problem<Dim>& problem, const Controls& controls, State<Dim>& state, double dt);

}  // namespace pfem
