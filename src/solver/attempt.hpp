#pragma once
// One try of a time step: Algorithm 1 and new connectivity.

#include "remesh/remesh.hpp"
#include "solver/fsiStep.hpp"

namespace pfem {

/// What a step has done, with all its tries.
struct AdvanceReport {
    StepReport step;
    NodeChanges mesh;
    double dt = 0;                     // the step that was accepted [s]
    int rejected = 0;                  // tries that were not
    int returned = 0;                  // nodes put back out of solids
    std::vector<std::string> reasons;  // of the rejections
    double seconds[2] = {0, 0};        // wall time of the step and of the remeshing
};

/// The state after a step of report.dt with its new connectivity; its time is left to the caller. A try counts when it
/// obeys solver/invariants.hpp. Throws FailedStep (or another StepFailure) when it cannot be accepted.
/// `triangulator`: keeps the triangulation for the next step, which gives the same as one from nothing.
template <int Dim>
State<Dim> attempt(const Problem<Dim>& problemOfRun, const Controls& controls, Triangulator<Dim>& triangulator,
                   const State<Dim>& last, AdvanceReport& report);

}  // namespace pfem
