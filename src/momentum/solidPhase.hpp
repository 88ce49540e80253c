#pragma once
// The solids of an iterate: domains, mass, stress.

#include "momentum/solidElementStress.hpp"
#include "momentum/trial.hpp"

namespace pfem {

/// What the momentum equation needs to know of the solids in one configuration.
template <int Dim>
struct SolidPhase {
    Solids<Dim> solids;
    SmoothingDomains<Dim> domains;       // at the end of the step
    SmoothingDomains<Dim> gradients;     // at the positions that the stress update asks for
    PerNode<double> mass;                // constant
    SolidStress<Dim> stress;             // sigma^{n+1}
    PerCell<Tensor<Dim>> elementStress;  // whose force is that of `stress` and of the damper

    /// As it is stored in `nodes`. The references must outlive the phase.
    SolidPhase(const Problem<Dim>& problem, const SolidControls& controls, const Mesh<Dim>& mesh,
               const NodeToCells& around, const Nodes<Dim>& nodes, Integration scheme);

    /// Domains and stress of the iterate `end`, dt after `old`.
    void moveTo(const Nodes<Dim>& old, const Nodes<Dim>& end, double dt);
};

}  // namespace pfem
