#pragma once
// The linear system for the pressure (44)-(45), with the elastic interface in its matrix.

#include <memory>

#include "continuity/stabilisation.hpp"
#include "linear/symmetricSolver.hpp"
#include "momentum/fluidPhase.hpp"
#include "momentum/solidMatrix.hpp"
#include "momentum/step.hpp"

namespace pfem {

/// Can ranks make the rows of their own nodes each, without the others'? Where a multigrid has neither solids nor
/// images in its matrix.
template <int Dim>
bool hasOwnRows(const Step<Dim>& step, const ContinuityControls& controls);

/// One sparse L D L^T per step of the quasi-definite matrix, in (dp, dv_boundary),
///
///     [ K_p   B    ]    K_p = Omega/(kappa dt) + (tau + s/(rho m)) L + w tau_n M_G
///     [ B^T  -A/c  ]    B_IJ = Omega_I G_IJ between pressures and boundary velocities
///
/// with mu and tau per cell, m = da/dv of the time integration, s = schurScale, w = freeSurfaceWeight, and c =
/// complianceScale at solids, freeSurfaceScale at the surface. Inside the fluid 1/(rho m) L bounds the exact Schur
/// complement B (m M)^{-1} B^T of the nodal integration from above, whatever the mesh; on its moving boundary it does
/// not. There the velocities are unknowns of the matrix: A is the momentum matrix of the solids at elastic interfaces
/// and the lumped mass at the free surface. Eliminating them adds c B A^{-1} B^T: what the boundary yields under
/// pressure. c > 1 covers the accelerations in the stabilisation's face terms. All of it, and the precision
/// in which the factor is kept, shapes the path of the iteration, not what it converges to.
template <int Dim>
class ContinuitySystem {
public:
    /// In the fluid's present configuration, whose nodes are at x. Of a share of the fluid the rows of its own nodes,
    /// which hasOwnRows must allow.
    ContinuitySystem(const Step<Dim>& step, const ContinuityControls& controls, const FluidPhase<Dim>& fluid,
                     const Stabilisation& stabilisation, const Points<Dim>& x, const SolidBlock<Dim>& solid);

    /// dp of all nodes for the right-hand side -R_c; zero outside the fluid.
    std::vector<double> solve(const std::vector<double>& residual) const;

    bool hasUnknown(int node) const { return unknown_[node] >= 0; }

private:
    int n_ = 0, nPressures_ = 0;
    int nOwn_ = 0;              // nodes that are no images
    std::vector<int> unknown_;  // per node: its pressure unknown or -1
    std::unique_ptr<SymmetricSolver> solver_;
};

}  // namespace pfem
