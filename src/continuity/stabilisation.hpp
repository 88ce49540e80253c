#pragma once
// Stabilisation parameter of the continuity equation (30).

#include "conditions/problem.hpp"
#include "continuity/controls.hpp"
#include "integration/smoothingDomains.hpp"

namespace pfem {

/// tau_e = 1 / (8 mu/h^2 + rho/dt + rho |v|/h) per fluid cell [m3 s/kg], h^Dim = Dim! |e|, |v| the mean of the
/// cell's nodes, mu per cell. Evaluated at the start of the step and kept.
template <int Dim>
PerCell<double> stabilisation(const Problem<Dim>& problem, const Cells<Dim>& cells,
                              const SmoothingDomains<Dim>& domains, const PerCell<double>& mu, const Points<Dim>& v,
                              double dt);

/// What a step keeps of the stabilisation, per cell.
struct Stabilisation {
    PerCell<double> tau;               // stabilisation()
    PerCell<unsigned char> projected;  // projectedCells()
};

/// tau_n of the terms on a face of the free surface, from tau and the present viscosity of its cell, with the present
/// height h_n of the cell over the face:
///     1/tau_n = max(1/tau, 4 (d+1) mu/h_n^2).
/// So the viscous stress 2 mu d_n in these terms takes from the face's nodes at most what its cell gives them by d_n to
/// the divergence, |e|/(d+1) d_n. With tau it is more wherever viscosity rules and h_n < 1.2 h, in flat cells so much
/// that no pressure solves the equation.
template <int Dim>
double surfaceStabilisation(double tau, double mu, double cellMeasure, double faceMeasure);

/// Per cell: does its stabilisation take the pressure's gradient less its projection (`projection`)? Not in films and
/// tips, where no node lies inside and the projection is the gradient itself; but in the last cell at a contact line
/// over a wall or solid that has inner nodes beside it. Not beside solids either, where impacts ask for the full
/// residual (doc/decisions.md), but at a contact line that hardly moves. `nodes`: at the start of the step.
template <int Dim>
PerCell<unsigned char> projectedCells(const ContinuityControls& controls, const Problem<Dim>& problem,
                                      const Cells<Dim>& cells, const Topology<Dim>& topology, const Nodes<Dim>& nodes);

}  // namespace pfem
