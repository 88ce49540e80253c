#pragma once
// Momentum residual (23)-(24).

#include "momentum/mass.hpp"

namespace pfem {

/// Consistent share of a traction patch: t |face|/d on each of its nodes [N/m (2D), N].
template <int Dim>
Points<Dim> tractionForce(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                          const Points<Dim>& x);

/// R_J = m_J (a_J - g) + sum_e |e| sigma_e grad N_J (fluid and solid patches) - traction, all nodes [N/m].
///   mass: fluid + solid;  stresses: element stresses equivalent to the nodal ones
template <int Dim>
Points<Dim> momentumResidual(const std::vector<double>& mass, const Points<Dim>& a, const Vec<Dim>& gravity,
                             const Patches<Dim>& fluid, const std::vector<Tensor<Dim>>& fluidStress,
                             const Patches<Dim>& solid, const std::vector<Tensor<Dim>>& solidStress,
                             const Points<Dim>& traction);

}  // namespace pfem
