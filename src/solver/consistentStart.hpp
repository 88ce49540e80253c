#pragma once
// Pressure and acceleration with which a run begins.

#include <functional>

#include "solver/fsiStep.hpp"

namespace pfem {

/// The constraints between two times [s] counted from the present one.
template <int Dim>
using ConstraintsOver = std::function<NodeConstraints<Dim>(double from, double to)>;

/// Pressure and acceleration at t = 0 that agree with the forces: one backward Euler step of the vanishing
/// length `moment` [s] of the incompressible fluid, of which only p and a are kept. Initial velocities that
/// walls and incompressibility do not allow are made so by an impulse before; p and a are then those of a step of a
/// thousand moments.
template <int Dim>
Nodes<Dim> consistentStart(Problem<Dim> problem, const Controls& controls, const State<Dim>& state,
                           const Topology<Dim>& topology, const ConstraintsOver<Dim>& constraintsOver, double moment);

}  // namespace pfem
