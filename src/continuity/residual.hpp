#pragma once
// Stabilised continuity (28)-(33), p positive in compression.

#include "continuity/controls.hpp"
#include "continuity/stabilisation.hpp"
#include "momentum/fluidPhase.hpp"
#include "momentum/trial.hpp"

namespace pfem {

/// Part of the lost volume that comes back per time [1/s]: 1/volumeReturnTime, but no more than a quarter within a
/// step. With the trapezoidal rule the volume answers late: with half of it per step small surface waves grow without
/// bounds.
double volumeReturnRate(const ContinuityControls& controls, double dt);

/// R_I = Omega_I/(kappa dt) (p_I - p_I^n) + Omega_I (div_I - divTarget) + tau [(L + M_G) p - f]_I  [m2/s],
/// with tau_n (stabilisation.hpp) in place of tau for M_G and 2 mu d_n.
/// x, p, a in the middle of the step, the divergence at its end. In projected cells (stabilisation.hpp) instead
/// of tau [...]:
///     sum_e tau_e |e| grad N_I . (grad p - mean of P_J over the nodes of e),   P_J: tau-weighted mean of grad p around
///     J
///   L:   |e| grad N_I . grad p per cell,       f: |e| grad N_I . rho g per cell
///   free-surface faces: M_G = (2/h_n) |face|/d,  f -= |face|/d (rho a_n - (2/h_n) 2 mu d_n)
///   interface faces:                             f -= |face|/d rho a_n
/// with h_n the cell's height over the face and n its outward normal. Wet nodes; zero elsewhere.
/// mu: viscosity of each cell. With `inertia` the volume term carries the full residual, f: rho (g - (v - v^n)/dt), and
/// the faces no acceleration. With `bodyForce` the face terms stand for the inertia of the whole field only where tau
/// is uniform; they take its mean tau_0, and cells carry the difference themselves, (tau - tau_0) |e| grad N_I . rho a.
/// So every uniformly accelerated state, free fall among them, satisfies the equation exactly whatever the tau of the
/// cells.
template <int Dim>
std::vector<double> continuityResidual(const Step<Dim>& step, const ContinuityControls& controls,
                                       const FluidPhase<Dim>& phase, const Stabilisation& stabilisation,
                                       const Trial<Dim>& trial);

}  // namespace pfem
