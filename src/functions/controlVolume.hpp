#pragma once
// Momentum of the fluid between two planes, and the rates that change it.

#include "conditions/problem.hpp"
#include "solver/controls.hpp"

namespace pfem {

/// The fluid between two planes, as a weight: 0 outside, 1 inside, a ramp of this width about each plane.
template <int Dim>
struct ControlVolume {
    Vec<Dim> from = Vec<Dim>::Zero(), direction = Vec<Dim>::Zero();  // a unit vector
    double length = 0, width = 0;                                    // [m]

    double weight(const Vec<Dim>& x) const;
    /// Is x nearer to the plane at `from`?
    bool isNearFrom(const Vec<Dim>& x) const { return direction.dot(x - from) < 0.5 * length; }
};

/// What changes the momentum along the direction, into the volume [N/m (2D), N]. With the weight w of the nodes
///     flow = int rho u (v . grad w),   pressure = int p (e . grad w),   u = e . v
/// in the layers about both planes.
struct MomentumRates {
    double flowFrom = 0, flowTo = 0, pressureFrom = 0, pressureTo = 0;
    double walls = 0;    // their force on the fluid, and that of solids
    double gravity = 0;  // int w rho g . e, and of the force that holds a flow through periodic sides
    double viscous = 0;  // viscosity, damping zones, panes

    std::array<double, 7> all() const { return {flowFrom, flowTo, pressureFrom, pressureTo, walls, gravity, viscous}; }
};

/// sum_i w_i m_i e . v_i with lumped masses and those of drops [kg/s (2D), kg m/s].
template <int Dim>
double momentumIn(const Problem<Dim>& problem, const State<Dim>& state, const ControlVolume<Dim>& volume);

template <int Dim>
MomentumRates momentumRates(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state,
                            const ControlVolume<Dim>& volume);

}  // namespace pfem
