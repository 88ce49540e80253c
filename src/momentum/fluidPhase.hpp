#pragma once
// The fluid of an iterate: its domains and its viscosity.

#include "momentum/fluidStress.hpp"

namespace pfem {

/// What both equations need to know of the fluid in one configuration.
template <int Dim>
struct FluidPhase {
    const Problem<Dim>& problem;
    const Cells<Dim>& cells;
    const PerNode<double>& pressure;  // of the nodes, at the start of the step: what the viscosity of grains takes
    SmoothingDomains<Dim> domains;
    bool newtonian;  // does the viscosity not depend on the flow?
    FlowViscosity<Dim> viscosity;
    PerCell<double> mu;   // [Pa s]
    int waiting = 0;      // so many configurations are still passed over
    bool follows = true;  // are the domains in the configuration that came last?

    /// As it is in `nodes`, of a share. The references must outlive the phase.
    FluidPhase(const Problem<Dim>& problem, const Mesh<Dim>& mesh, const NodeToCells& around, const Nodes<Dim>& nodes,
               Integration scheme, const Share& share = {});

    /// The next configuration: the domains go to x, unless they wait.
    void moveTo(const Points<Dim>& x);

    /// Pass over the next `count` configurations.
    void wait(int count) { waiting = count; }

    /// From now on domains and viscosity are those of a share alone.
    void divide(const Share& share) { domains.share = share; }

    /// The same with all domains, which are at x unless they wait, and their viscosity (collective).
    FluidPhase whole(const Points<Dim>& x) const;

    /// The viscosity in the flow v, where it depends on it.
    void flow(const Points<Dim>& v);

    /// Viscosity of the cells against a change of the flow in its own direction [Pa s].
    PerCell<double> tangent() const;
};

}  // namespace pfem
