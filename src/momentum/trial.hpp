#pragma once
// The iterate of a step: nodes at its end and where the forces act.

#include "momentum/step.hpp"

namespace pfem {

template <int Dim>
struct Trial {
    Nodes<Dim> end;              // at t^{n+1}, with the step's pressure
    Nodes<Dim> middle;           // x and v at t^n + gamma dt, the step's pressure and acceleration
    std::vector<double> excess;  // p - rho g . x: what the iteration changes [Pa]. So nodes take the pressure of their
                                 // depth along
    Vec<Dim> depth;              // rho g, or zero in steps that are short beside sqrt(h/g) [Pa/m]
    std::vector<Twist<Dim>> twist;      // of the rigid bodies at t^{n+1}
    Vec<Dim> drive = Vec<Dim>::Zero();  // acceleration of the body force that holds the flow through periodic sides
};

/// Everything moves on with the velocities and the excess of t^n.
template <int Dim>
Trial<Dim> firstTrial(const Step<Dim>& step);

/// v += part dv, and the positions and accelerations that follow (22). Isolated particles are in ballistic flight,
/// slide down their wall or stick to it. What follows a moving wall does so whatever dv says.
template <int Dim>
void changeVelocity(const Step<Dim>& step, double part, const Points<Dim>& dv, Trial<Dim>& trial);

/// The pressure of this excess.
template <int Dim>
void setExcess(const Step<Dim>& step, const std::vector<double>& excess, Trial<Dim>& trial);

}  // namespace pfem
