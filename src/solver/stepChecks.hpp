#pragma once
// What a step cannot be accepted with.

#include "momentum/fluidPhase.hpp"
#include "momentum/solidPhase.hpp"
#include "solver/fsiStep.hpp"

namespace pfem {

/// Would the motion to x leave less than a fifth of some fluid cell? So it is at an impact, before the pressure has
/// answered; residuals of cells turned inside out would only mislead the iteration.
template <int Dim>
bool collapses(const FluidPhase<Dim>& fluid, const Points<Dim>& x);

/// Throws StepFailure for a solid element that is turned inside out or a fluid patch without volume.
template <int Dim>
void checkDomains(const FluidPhase<Dim>& fluid, const SolidPhase<Dim>& solid, const Nodes<Dim>& nodes);

/// A step that did not converge: how far it came, and where the pressure still changes most.
template <int Dim>
StepFailure notConverged(const StepReport& report, const std::vector<double>& dp, const Nodes<Dim>& nodes,
                         const SmoothingDomains<Dim>& fluid);

}  // namespace pfem
