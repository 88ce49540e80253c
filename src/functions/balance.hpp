#pragma once
// The solver's own momentum balance of a written state: what supports must give, and what the stresses are.

#include "conditions/problem.hpp"
#include "solver/controls.hpp"

namespace pfem {

/// R_J = m_J (a_J - g) + internal forces - tractions and friction of every node, the residual of the step [N/m (2D),
/// N]: zero where a node moves freely, the force of the support where it is held.
template <int Dim>
Points<Dim> supportForces(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state);

}  // namespace pfem
