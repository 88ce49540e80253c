#pragma once
// The part of a change of volume that the pressure explains: fluid that is pressed together is not lost.

#include "conditions/problem.hpp"
#include "mesh/adjacency.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

/// How the patch of each node changes by the change of its pressure, as the continuity equation has it:
/// - Omega_I (p_I - p_I^n)/kappa [m2 (2D), m3], Omega_I at the end of the step. `around`: the fluid's cells of the
/// nodes. By ranks that share the work.
template <int Dim>
std::vector<double> compressedVolume(const Problem<Dim>& problem, const Cells<Dim>& cells, const NodeToCells& around,
                                     const Nodes<Dim>& now, const std::vector<double>& pOld, const Ranks& ranks = {});

}  // namespace pfem
