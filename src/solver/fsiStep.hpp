#pragma once
// One time step: Algorithm 1.

#include <functional>

#include "solver/controls.hpp"
#include "solver/failedStep.hpp"
#include "state/problem.hpp"

namespace pfem {

/// What one step did; for the log.
struct StepReport {
    int iterations = 0;
    int linearIterations = 0;         // conjugate gradients, all iterations together
    double initialU = 0, finalU = 0;  // |dv|/|v| of the first and the last iteration
    double initialP = 0, finalP = 0;  // |dp|/|p|
};

template <int Dim>
struct StepResult {
    Nodes<Dim> nodes;
    std::vector<Stress<Dim>> cellSigma;  // of the solid's cells, for Cells::sigma; empty with nodal integration
    StepReport report;
};

/// From state n to n+1 over dt. `divTarget`: wanted divergence of the fluid [1/s], 0 without volume correction.
/// The velocities in `old` obey the constraints.
/// Throws FailedStep with the nodes of the last trial when the step cannot be accepted; `old` is untouched.
template <int Dim>
StepResult<Dim> fsiStep(const Problem<Dim>& problem, const Controls& controls, const Mesh<Dim>& mesh,
                        const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, const Nodes<Dim>& old,
                        double dt, double divTarget);

/// The constraints between two times [s] counted from the present one.
template <int Dim>
using ConstraintsOver = std::function<NodeConstraints<Dim>(double from, double to)>;

/// Pressure and acceleration at t = 0 that agree with the forces: one backward Euler step of the vanishing
/// length `moment` [s] of the incompressible fluid, of which only p and a are kept. Initial velocities that
/// walls and incompressibility do not allow are made so by an impulse before; p and a are then those of a step of a
/// thousand moments.
template <int Dim>
Nodes<Dim> consistentStart(Problem<Dim> problem, Controls controls, const Mesh<Dim>& mesh,
                           const Topology<Dim>& topology, const ConstraintsOver<Dim>& constraintsOver,
                           const Nodes<Dim>& nodes, double moment);

}  // namespace pfem
