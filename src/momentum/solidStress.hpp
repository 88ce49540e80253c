#pragma once
// Stress of the solid's patches at the end of the step (36)-(39), and the zig-zag damper.

#include "integration/nodalPatches.hpp"
#include "momentum/controls.hpp"
#include "momentum/newmark.hpp"
#include "state/problem.hpp"

namespace pfem {

/// Material of each solid node: that of its first cell (bodies of different materials do not share patches).
template <int Dim>
const Hypoelastic& solidMaterial(const Problem<Dim>& problem, const Cells<Dim>& cells, const NodeToCells& around,
                                 int node);

/// sigma^{n+1} from sigma^n and the trial motion, evaluated afresh at every iteration.
///   midpoint: patches at (x^n + x)/2 (rotatedMidpoint);  end: patches at x (paper)
template <int Dim>
std::vector<Stress<Dim>> solidStress(const Problem<Dim>& problem, const SolidControls& controls,
                                     const Cells<Dim>& cells, const Patches<Dim>& midpoint,
                                     const Patches<Dim>& end, const Nodes<Dim>& old, const Nodes<Dim>& trial,
                                     double dt);

/// Element stress that makes the nodal force: the mean of the cell's nodal stresses plus the damper's
/// tau_s (C d_e - mean over the cell's nodes of C d_I), which vanishes for linear velocity fields.
template <int Dim>
std::vector<Tensor<Dim>> solidElementStress(const Problem<Dim>& problem, const SolidControls& controls,
                                            const Cells<Dim>& cells, const Patches<Dim>& end,
                                            const Nodes<Dim>& trial);

/// tau_s = alpha h sqrt(rho/E) [s].
double dampingTime(const Hypoelastic& material, double alpha, double h);

}  // namespace pfem
