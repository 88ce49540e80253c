#pragma once
// What is outside of an outlet presses on the water that leaves.

#include "conditions/problem.hpp"

namespace pfem {

/// Pressure outside of the outlet at x [Pa]: `pressure`, or that of still water and of waves that go out with the phase
/// velocity c (`waveSpeed`), max(0, rho (|g| level + g . x) + rho c v . n). In a small wave that goes along n,
/// p = rho c v . n holds at every depth: nothing of it comes back. Of one with the phase velocity c' the part
/// (c' - c)/(c' + c) does.
template <int Dim>
double outsidePressure(const Problem<Dim>& problem, const Outlet& outlet, double rho, const Vec<Dim>& x,
                       double outflow = 0);

/// Add - int_f p N_J n dS of all wet faces on outlets, p linear between the nodes, to the external force: hydrostatic
/// pressure of the same level inside is in balance with it, exactly.
template <int Dim>
void addOutletPressure(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                       const Nodes<Dim>& nodes, Points<Dim>& force);

/// Its derivative by the velocity, lumped, rho c |f|/d along n: for the matrices, as surfaceStiffness.
template <int Dim>
void addOutletStiffness(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                        const Points<Dim>& x, Points<Dim>& stiffness);

}  // namespace pfem
