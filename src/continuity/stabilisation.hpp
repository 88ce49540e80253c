#pragma once
// Stabilisation parameter of the continuity equation (30).

#include "integration/nodalPatches.hpp"
#include "state/problem.hpp"

namespace pfem {

/// tau_e = 1 / (8 mu/h^2 + rho/dt + rho |v|/h) per fluid cell [m3 s/kg], h^Dim = Dim! |e|, |v| the mean of the
/// cell's nodes, mu per cell. Evaluated at the start of the step and kept.
template <int Dim>
std::vector<double> stabilisation(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                  const Patches<Dim>& patches, const std::vector<double>& mu, const Points<Dim>& v,
                                  double dt);

}  // namespace pfem
