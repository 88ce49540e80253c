#pragma once
// The part of a change of volume that the pressure explains: fluid that is pressed together is not lost.

#include "conditions/problem.hpp"
#include "integration/smoothingDomains.hpp"

namespace pfem {

/// How the patch of each node changes by the change of its pressure, as the continuity equation has it:
/// - Omega_I (p_I - p_I^n)/kappa [m2 (2D), m3], Omega_I at the end of the step. `around`: the fluid's cells of the
/// nodes.
template <int Dim>
std::vector<double> compressedVolume(const Problem<Dim>& problem, const Cells<Dim>& cells, const NodeToCells& around,
                                     const Nodes<Dim>& now, const std::vector<double>& pOld);

}  // namespace pfem
