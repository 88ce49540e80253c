#pragma once
// Papanastasiou's regularisation of a yield stress.

#include <cmath>

namespace pfem {

/// (1 - exp(-m g))/g [s]: the yield stress times it is a viscosity; 1/g where the material flows, m where it hardly
/// does.
inline double yieldingTime(double m, double g) { return m * g < 1e-8 ? m : -std::expm1(-m * g) / g; }

/// Its derivative with g [s2].
inline double yieldingTimeSlope(double m, double g) {
    const double mg = m * g;
    return mg < 1e-4 ? m * m * (mg / 3 - 0.5) : (mg * std::exp(-mg) + std::expm1(-mg)) / (g * g);
}

}  // namespace pfem
