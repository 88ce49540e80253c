#pragma once
// Viscous stress of the fluid (35), nodal or elemental as its patches say.

#include "integration/stressPoints.hpp"
#include "state/problem.hpp"

namespace pfem {

/// Does the viscosity of no fluid depend on the flow?
template <int Dim>
bool isNewtonian(const Problem<Dim>& problem);

/// mu of every stress point in the flow v [Pa s]; 0 outside the material.
template <int Dim>
std::vector<double> pointViscosity(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                                   const Points<Dim>& v);

/// Element stress with the force of the points' sigma = 2 mu (d - tr(d)/3 I) - p I. The nodal pressure acts by its mean
/// over each element with both integrations.
template <int Dim>
std::vector<Tensor<Dim>> fluidStress(const Patches<Dim>& patches, const std::vector<double>& mu, const Points<Dim>& v,
                                     const std::vector<double>& p);

/// The same without pressure plus `bulk` * tr(d) I per stress point (empty: none): the operator of the momentum matrix
/// (42)-(43).
template <int Dim>
std::vector<Tensor<Dim>> fluidTangentStress(const Patches<Dim>& patches, const std::vector<double>& mu,
                                            const Points<Dim>& dv, const std::vector<double>& bulk);

}  // namespace pfem
