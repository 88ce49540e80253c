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

/// tau_n of the terms on a face of the free surface, from tau and mu of its cell: with the height h_n of the cell over the face,
///     1/tau_n = 1/tau + mu (4 (d+1)/h_n^2 - 8/h^2)_+.
/// So the viscous stress 2 mu d_n in these terms cannot outweigh what the cell gives to the divergence of the face's nodes,
/// |e|/(d+1) d_n, whatever its shape; with tau it does in flat cells of thick fluids, and no pressure solves the equation there.
template <int Dim>
double surfaceStabilisation(double tau, double mu, double cellMeasure, double faceMeasure);

}  // namespace pfem
