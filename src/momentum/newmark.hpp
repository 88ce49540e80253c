#pragma once
// Newmark's time integration (22), in velocities.

#include "momentum/boundaryConditions.hpp"

namespace pfem {

/// a^{n+1} = (v^{n+1} - v^n)/(gamma dt) - (1-gamma)/gamma a^n,   x^{n+1} = x^n + dt/2 (v^n + v^{n+1}).
struct Newmark {
    double dt;           // [s]
    double gamma = 0.5;  // 1/2 trapezoidal, 1 backward Euler

    /// da/dv [1/s].
    double massFactor() const { return 1 / (gamma * dt); }

    template <int Dim>
    Vec<Dim> acceleration(const Vec<Dim>& vOld, const Vec<Dim>& v, const Vec<Dim>& aOld) const {
        return (v - vOld) / (gamma * dt) - (1 - gamma) / gamma * aOld;
    }

    template <int Dim>
    Vec<Dim> position(const Vec<Dim>& xOld, const Vec<Dim>& vOld, const Vec<Dim>& v) const {
        return xOld + 0.5 * dt * (vOld + v);
    }
};

}  // namespace pfem
