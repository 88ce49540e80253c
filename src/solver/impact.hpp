#pragma once
// Surfaces that have just met.

#include "conditions/problem.hpp"
#include "state/state.hpp"

namespace pfem {

/// A new contact of fluid with fluid or a rigid wall is an inelastic impact (solver/inelastic.hpp): where the
/// velocities would close the cell, impulses along its gradients,
///   m_I dv_I = lambda grad N_I   with lambda such that   div v = 0,
/// act on its nodes at once. Momentum and moment of momentum of the nodes that are free stay (sum_I grad N_I = 0,
/// sum_I x_I x grad N_I = 0); energy is lost. What is held takes none, what slides along a wall its part along it. No
/// node gets more speed than the fastest of those that met had (walls that move: more than that and their own): where
/// the impulses would throw a light node, a part of the relative velocities goes, too. Without it the flat cell would
/// hold the step at a fraction of its height until pressure has answered. Solids, whose nodes have neighbours to pull
/// back at once, get their impulse from the pressure of the next step: cells with their nodes are left. `contacts`:
/// fluid cells of the state; they share nodes and are struck in turns, at most 20, until none closes at more than 1 %
/// of the fastest at the start. Nodes that a wall holds from now on get the velocity that it allows. `problem`: that of
/// the state's time.
template <int Dim>
void strike(const Problem<Dim>& problem, const std::vector<Simplex<Dim>>& contacts, State<Dim>& state);

}  // namespace pfem
