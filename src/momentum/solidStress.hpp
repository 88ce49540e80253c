#pragma once
// Stress of the solid's stress points at the end of the step (36)-(39), and the zig-zag damper.

#include "integration/stressPoints.hpp"
#include "momentum/controls.hpp"
#include "momentum/newmark.hpp"
#include "state/problem.hpp"

namespace pfem {

/// Material of a stress point.
template <int Dim>
const Hypoelastic& solidMaterial(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                                 int point);

/// The positions whose gradients the stress update takes: (x^n + x)/2 (rotatedMidpoint), x (paper), X (neoHookean).
template <int Dim>
Points<Dim> gradientPositions(const SolidControls& controls, const Nodes<Dim>& old, const Nodes<Dim>& trial);

/// sigma^{n+1} of every stress point from sigma^n (stored in old.sigma or cells.sigma) and the trial motion, evaluated
/// afresh at every iteration; of points outside the material the stored value.
///   patches: at gradientPositions
template <int Dim>
std::vector<Stress<Dim>> solidStress(const Problem<Dim>& problem, const SolidControls& controls,
                                     const Cells<Dim>& cells, const Patches<Dim>& patches, const Nodes<Dim>& old,
                                     const Nodes<Dim>& trial, double dt);

/// Element stress that makes the nodal force from the points' stress `sigma` (fromPoints), plus the damper's
/// tau_s C : (d_e - fromPoints(d)_e), which vanishes for linear velocity fields and for elemental integration.
///   patches: at gradientPositions;  end: at trial.x
template <int Dim>
std::vector<Tensor<Dim>> solidElementStress(const Problem<Dim>& problem, const SolidControls& controls,
                                            const Cells<Dim>& cells, const Patches<Dim>& patches,
                                            const Patches<Dim>& end, const std::vector<Stress<Dim>>& sigma,
                                            const Nodes<Dim>& trial);

/// tau_s = alpha h sqrt(rho/E) [s].
double dampingTime(const Hypoelastic& material, double alpha, double h);

}  // namespace pfem
