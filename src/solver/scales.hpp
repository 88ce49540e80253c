#pragma once
// Sizes beside which the changes of an iteration are measured.

#include "momentum/fluidPhase.hpp"
#include "momentum/step.hpp"

namespace pfem {

/// Mean of the nodes' wanted distances [m].
template <int Dim>
double meanSize(const Nodes<Dim>& nodes);

/// A speed that moves nothing within a step: so that where nothing moves yet no change is measured by round-off, that
/// of far places included [m/s].
template <int Dim>
double unseenSpeed(const Step<Dim>& step);

/// A speed that no tolerance can ask for: the round-off of pressures and stresses that balance each other, and stress
/// that follows from positions (hyperelastic solids) has their round-off times the stiffness, and what that moves
/// within the step is noise, at most the round-off itself [m/s].
template <int Dim>
double roundOffSpeed(const Step<Dim>& step);

/// Largest density times g times the mean node distance: the pressure that one layer of fluid makes [Pa]. Added to it:
/// a part of rho v^2, which keeps the round-off of a flow without gravity or pressure from counting as a change; what
/// cannot be told apart of the velocities over the length of the step and the tolerance; what stops `unseenSpeed`
/// within the step; what stops `roundOffSpeed`, over the tolerance; and the root mean square of 2 mu |d| over the
/// cells, beside which a pressure need not be exact.
template <int Dim>
double pressureScale(const Step<Dim>& step, const FluidPhase<Dim>& fluid, double tolerance);

}  // namespace pfem
