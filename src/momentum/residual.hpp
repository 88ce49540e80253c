#pragma once
// Momentum residual (23)-(24).

#include "momentum/mass.hpp"

namespace pfem {

/// Consistent share of a traction patch: t |face|/d on each of its nodes [N/m (2D), N].
template <int Dim>
Points<Dim> tractionForce(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions, const Points<Dim>& x);

/// R_J = m_J (a_J - g) - sum_e |e| p_e grad N_J (fluid) + sum_e |e| sigma_e grad N_J (solid) - external, all nodes
/// [N/m].
///   mass: fluid + solid;  solidStress: element stresses equivalent to those of the stress points
///   external: tractions, friction at walls, minus the viscous force
template <int Dim>
Points<Dim> momentumResidual(const std::vector<double>& mass, const Points<Dim>& a, const Vec<Dim>& gravity,
                             const Patches<Dim>& fluid, const std::vector<double>& p, const Patches<Dim>& solid,
                             const std::vector<Tensor<Dim>>& solidStress, const Points<Dim>& external);

}  // namespace pfem
