#pragma once
// Isotropic hardening of a von Mises yield stress: linear and Voce's.

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dictionary/range.hpp"

namespace pfem {

/// sigma_y(a) = yieldStress + hardening a + (saturationStress - yieldStress)(1 - exp(-saturationRate a)), a the
/// equivalent plastic strain.
struct Hardening {
    double yieldStress = 0, modulus = 0, saturationStress = 0, saturationRate = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("yieldStress", yieldStress, "Pa", "von Mises stress at which the solid yields first", positive);
        v("hardening", modulus, "Pa", "linear: growth of the yield stress with the equivalent plastic strain",
          nonNegative);
        v("saturationStress", saturationStress, "Pa", "Voce's: where the yield stress goes without the linear part",
          nonNegative);
        v("saturationRate", saturationRate, "-", "Voce's: how soon, exp(-saturationRate a); 0: no such part",
          nonNegative);
    }
    std::string fault() const {
        return saturationRate > 0 && saturationStress < yieldStress
                   ? "'saturationStress' must not be below 'yieldStress': a solid that softens has no unique answer"
                   : "";
    }
    double stress(double a) const { return yieldStress + modulus * a - saturating() * std::expm1(-saturationRate * a); }
    double slope(double a) const { return modulus + saturating() * saturationRate * std::exp(-saturationRate * a); }

    /// Plastic strain x of a step whose elastic trial has the von Mises stress q: q - stiffness x = stress(a + x), or 0
    /// where it does not yield. Newton from below; the stress is concave, so it comes nearer with each step.
    double plasticStrain(double q, double a, double stiffness) const {
        double x = 0;
        if (q <= stress(a)) return x;
        for (int n = 0; n < 100; ++n) {
            const double dx = (q - stiffness * x - stress(a + x)) / (stiffness + slope(a + x));
            x += dx;
            if (dx <= 4e-15 * q / stiffness) return x;  // the round-off of q
        }
        throw StepFailure("radial return of a plastic solid without convergence");
    }

private:
    double saturating() const { return saturationRate > 0 ? saturationStress - yieldStress : 0; }
};

}  // namespace pfem
