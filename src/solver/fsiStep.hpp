#pragma once
// One time step: Algorithm 1.

#include "momentum/step.hpp"
#include "solver/controls.hpp"
#include "solver/failedStep.hpp"

namespace pfem {

/// What one step did; for the log.
struct StepReport {
    int iterations = 0;
    int linearIterations = 0;         // conjugate gradients, all iterations together
    double initialU = 0, finalU = 0;  // |dv|/|v| of the first and the last iteration
    double initialP = 0, finalP = 0;  // |dp|/|p|
    Eigen::Vector3d drive{0, 0, 0};   // Trial::drive [m/s2]
};

template <int Dim>
struct StepResult {
    Nodes<Dim> nodes;
    std::vector<Stress<Dim>> cellSigma;  // of the solid's cells, for Cells::sigma; empty with nodal integration
    History cellHistory;                 // the same for Cells::history
    StepReport report;
};

/// From state n to n+1. Throws FailedStep with the nodes of the last trial when the step cannot be accepted.
template <int Dim>
StepResult<Dim> fsiStep(const Step<Dim>& step, const Controls& controls);

}  // namespace pfem
