#pragma once
// Stress of the solid's stress points at the end of the step (36)-(39).

#include "conditions/problem.hpp"
#include "integration/stressPoints.hpp"
#include "momentum/solids.hpp"

namespace pfem {

/// Material of a stress point.
template <int Dim>
const Solid& solidMaterial(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                           int point);

/// Omega_I(x) / Omega_I of the domains: how much the volume of each node has grown; 1 outside the material. The nodal
/// volume is the sum of its cells', so a node may have J > 0 beside an inverted cell.
template <int Dim>
PerNode<double> volumeRatio(const SmoothingDomains<Dim>& reference, const Points<Dim>& x);

/// The solid's stress in one iterate.
template <int Dim>
struct SolidStress {
    PerPoint<Stress<Dim>> point;  // sigma, or s (see solidStress) where there is a pressure
    PerNode<double> pressure;     // velocityPressure: p, zero outside the material; else empty
    History history = {};         // per stress point: what the laws remember at the end of the step
};

/// sigma^{n+1} of every stress point from sigma^n (stored in old.sigma or cells.sigma) and the trial motion, evaluated
/// afresh at every iteration; of points outside the material the stored value. velocityPressure: s of the stress points
/// and p of the nodes. Of laws in rates p = p^n - kappa tr(De_I) with the strain increment of the nodal patch: that is
/// the mass equation (1/kappa) dp/dt + div v = 0 with lumped test functions, solved for p at each node; s is the
/// deviator. Of hyperelastic laws p = - U'(J) with J = Omega_I/Omega_I0, and s the rest: both are derivatives of the
/// energy sum_p Omega_p W_s(F_p) + sum_I Omega_I0 U(Omega_I/Omega_I0).
///   domains: updateGradientDomains
template <int Dim>
SolidStress<Dim> solidStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains, const Nodes<Dim>& old,
                             const Nodes<Dim>& trial, double dt);

}  // namespace pfem
