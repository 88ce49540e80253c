#pragma once
// The solver's own momentum balance of a written state: what supports must give, and what the stresses are.

#include "conditions/problem.hpp"
#include "solver/controls.hpp"

namespace pfem {

/// R_J = m_J (a_J - g) + internal forces - tractions and friction of every node, the residual of the step [N/m (2D),
/// N]: zero where a node moves freely, the force of the support where it is held.
template <int Dim>
Points<Dim> supportForces(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state);

/// The acceleration of the body force that holds the flow through periodic sides, as the momentum of the state asks for
/// it: what its free nodes have beside all other forces, on the average. Zero where no flow is held [m/s2].
template <int Dim>
Vec<Dim> driveOf(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state);

}  // namespace pfem
