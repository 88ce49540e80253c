#pragma once
// Time integration in velocities: the midpoint rule in place of Newmark's trapezoidal (22); doc/theory.md, section 3.

#include "base/types.hpp"

namespace pfem {

/// v^{n+1} = v^n + dt a,   x^{n+1} = x^n + dt/2 (v^n + v^{n+1}),   a and all forces at t^n + gamma dt: x = (1-gamma)
/// x^n + gamma x^{n+1} and v likewise. gamma 1/2: midpoint rule, 1: backward Euler.
struct MidpointRule {
    double dt;  // [s]
    double gamma = 0.5;

    /// Factor of the mass in the matrix of dv, which is the derivative of the forces at the end of the step [1/s].
    double massFactor() const { return 1 / (gamma * dt); }

    template <int Dim>
    Vec<Dim> acceleration(const Vec<Dim>& vOld, const Vec<Dim>& v) const {
        return (v - vOld) / dt;
    }

    /// Of solids, whose forces are those of both ends: the acceleration at the end, for the eye and for reactions.
    template <int Dim>
    Vec<Dim> endAcceleration(const Vec<Dim>& vOld, const Vec<Dim>& v, const Vec<Dim>& aOld) const {
        return (v - vOld) / (gamma * dt) - (1 - gamma) / gamma * aOld;
    }

    template <int Dim>
    Vec<Dim> position(const Vec<Dim>& xOld, const Vec<Dim>& vOld, const Vec<Dim>& v) const {
        return xOld + 0.5 * dt * (vOld + v);
    }

    /// A quantity in the middle of the step from its values at the ends.
    template <int Dim>
    Vec<Dim> middle(const Vec<Dim>& old, const Vec<Dim>& now) const {
        return (1 - gamma) * old + gamma * now;
    }
};

}  // namespace pfem
