#pragma once
// What is outside of an outlet presses on the water that leaves.

#include "conditions/problem.hpp"

namespace pfem {

/// Pressure outside of the outlet at x [Pa]: `pressure`, or max(0, rho (|g| level + g . x)) of still water.
template <int Dim>
double outsidePressure(const Problem<Dim>& problem, const Outlet& outlet, double rho, const Vec<Dim>& x);

/// Add - int_f p N_J n dS of all wet faces on outlets, p linear between the nodes, to the external force: hydrostatic
/// pressure of the same level inside is in balance with it, exactly.
template <int Dim>
void addOutletPressure(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                       const Points<Dim>& x, Points<Dim>& force);

}  // namespace pfem
