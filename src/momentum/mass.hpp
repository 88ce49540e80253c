#pragma once
// Lumped nodal masses.

#include "conditions/problem.hpp"
#include "integration/smoothingDomains.hpp"

namespace pfem {

/// sum_e rho_e |e|/(d+1) over the fluid around each node, in the configuration of the domains [kg/m (2D), kg].
template <int Dim>
PerNode<double> fluidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains);

/// The same in positions x, where there are no domains.
template <int Dim>
PerNode<double> fluidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const Points<Dim>& x);

/// Constant mass of the solid's nodes: rho_0 Omega_0 in the reference positions X.
template <int Dim>
PerNode<double> solidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const Points<Dim>& X);

}  // namespace pfem
