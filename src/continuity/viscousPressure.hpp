#pragma once
// The pressure's answer to a divergence that viscosity, not inertia, resists.

#include "integration/smoothingDomains.hpp"

namespace pfem {

/// dp_I -= scale mu_I R_I / Omega_I. The Schur complement B A^{-1} B^T of mass and viscosity together, A = rho/dt M +
/// mu L, has about the inverse (rho/dt) L_p^{-1} + mu M_p^{-1} (Cahouet and Chabard 1988): the pressure matrix is the
/// first part, this is the second. It shapes the path of the iteration, never the converged step. `mu`: of the cells
/// [Pa s]; `scale`: of each node; `residual`: R_c [m2/s (2D)].
template <int Dim>
void addViscousPressure(const SmoothingDomains<Dim>& fluid, const PerCell<double>& mu, const PerNode<double>& scale,
                        const PerNode<double>& residual, PerNode<double>& dp);

}  // namespace pfem
