#pragma once
// The fluid of an iterate: its domains and its viscosity.

#include "momentum/fluidStress.hpp"

namespace pfem {

/// What both equations need to know of the fluid in one configuration.
template <int Dim>
struct FluidPhase {
    const Problem<Dim>& problem;
    const Cells<Dim>& cells;
    const std::vector<double>& pressure;  // of the nodes, at the start of the step: what the viscosity of grains takes
    SmoothingDomains<Dim> domains;
    bool newtonian;                // does the viscosity not depend on the flow?
    FlowViscosity<Dim> viscosity;  // of the stress points
    std::vector<double> mu;        // of the cells [Pa s]

    /// As it is in `nodes`. The references must outlive the phase.
    FluidPhase(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const NodeToCells& around, const Nodes<Dim>& nodes,
               Integration scheme);

    /// The domains at x.
    void moveTo(const Points<Dim>& x) { updateSmoothingDomains<Dim>(domains, x); }

    /// The viscosity in the flow v, where it depends on it.
    void flow(const Points<Dim>& v);

    /// Viscosity of the cells against a change of the flow in its own direction [Pa s].
    std::vector<double> tangent() const;
};

}  // namespace pfem
