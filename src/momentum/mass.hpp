#pragma once
// Lumped nodal masses.

#include "integration/nodalPatches.hpp"
#include "state/problem.hpp"

namespace pfem {

/// sum_e rho_e |e|/(d+1) over the fluid around each node, in the configuration of the patches [kg/m (2D), kg].
template <int Dim>
std::vector<double> fluidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches);

/// The same in positions x, where there are no patches.
template <int Dim>
std::vector<double> fluidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const Points<Dim>& x);

/// Constant mass of the solid's nodes: rho_0 Omega_0 in the reference positions X.
template <int Dim>
std::vector<double> solidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const Points<Dim>& X);

}  // namespace pfem
