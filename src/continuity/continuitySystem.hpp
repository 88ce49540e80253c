#pragma once
// The linear system for the pressure (44)-(45), with the elastic interface in its matrix.

#include "continuity/controls.hpp"
#include "integration/nodalPatches.hpp"
#include "linear/ldlt.hpp"
#include "momentum/solidMatrix.hpp"
#include "state/problem.hpp"

namespace pfem {

/// One sparse L D L^T per step of the quasi-definite matrix, in (dp, dv_solid),
///
///     [ K_p   B     ]    K_p = Omega/(kappa dt) + (tau + 1/(rho m)) L + free-surface diagonal
///     [ B^T  -A_s/c ]    B_IJ = Omega_I G_IJ between fluid patches and interface velocities
///
/// with m = da/dv of the time integration. Eliminating dv_solid adds c B A_s^{-1} B^T: what the elastic interface
/// yields under pressure. It shapes the path of the iteration, never the converged step.
template <int Dim>
class ContinuitySystem {
public:
    ContinuitySystem(const Problem<Dim>& problem, const ContinuityControls& controls, const Cells<Dim>& cells,
                     const Topology<Dim>& topology, const Patches<Dim>& patches,
                     const std::vector<double>& tau, const Points<Dim>& x, const SolidDofs<Dim>& solidDofs,
                     const SymmetricMatrix& solidMatrix, const Newmark& newmark);

    /// dp of all nodes for the right-hand side -R_c; zero outside the fluid.
    std::vector<double> solve(const std::vector<double>& residual) const;

    bool hasUnknown(int node) const { return unknown_[node] >= 0; }

private:
    int nPressure_ = 0;
    int n_ = 0;
    std::vector<int> unknown_;  // per node: its pressure unknown or -1
    Ldlt factor_;
};

}  // namespace pfem
