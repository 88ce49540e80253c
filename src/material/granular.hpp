#pragma once
// Dry grains as fluids whose shear stress grows with the pressure.

#include <algorithm>
#include <string>

#include "dictionary/range.hpp"
#include "material/fluidLaw.hpp"
#include "material/papanastasiou.hpp"

namespace pfem {

inline const char* const creepMeaning =
    "Papanastasiou's time: below 1/m it creeps with m times the strength; some hundred times sqrt(height/g), for more "
    "makes friction and pressure chase each other";

/// Drucker and Prager's cone, in the plane Mohr and Coulomb's: tau = cohesion cos(phi) + p sin(phi) + mu g, with
/// Papanastasiou's regularisation. Suction makes no friction.
class DruckerPrager : public FluidLawOf<DruckerPrager> {
public:
    double frictionAngle = 30, cohesion = 0, mu = 0, m = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("frictionAngle", frictionAngle, "-", "phi, in degrees", between(0, 89));
        v("cohesion", cohesion, "Pa", "shear stress that it stands without pressure", nonNegative);
        v("mu", mu, "Pa s", "viscosity beside", nonNegative);
        v.required("m", m, "s", creepMeaning, positive);
    }
    double viscosity(double g, double p) const override { return mu + strength(p) * yieldingTime(m, g); }
    double slope(double g, double p) const override { return strength(p) * yieldingTimeSlope(m, g); }

private:
    double strength(double p) const {
        const double phi = frictionAngle * M_PI / 180;
        return cohesion * std::cos(phi) + std::max(p, 0.0) * std::sin(phi);
    }
};

/// The mu(I) rheology (Jop, Forterre and Pouliquen 2006): tau = mu(I) p, mu(I) = muS + (mu2 - muS)/(1 + I0/I), I = g d
/// sqrt(rhoGrains/p), muS p with Papanastasiou's regularisation.
class MuI : public FluidLawOf<MuI> {
public:
    double muS = 0, mu2 = 0, I0 = 0.3, grainSize = 0, grainDensity = 0, muMin = 0, m = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("muS", muS, "-", "friction of slow flow", positive);
        v.required("mu2", mu2, "-", "friction of quick flow", positive);
        v("I0", I0, "-", "inertial number at which it is their mean", positive);
        v.required("grainSize", grainSize, "m", "diameter of the grains", positive);
        v.required("grainDensity", grainDensity, "kg/m3", "of their stuff", positive);
        v("muMin", muMin, "Pa s", "viscosity without pressure", nonNegative);
        v.required("m", m, "s", creepMeaning, positive);
    }
    std::string fault() const { return mu2 >= muS ? "" : "'mu2' must not be below 'muS'"; }

    // mu(I) p/g: with I = g T, T = d sqrt(rhoGrains/p), the second part is (mu2 - muS) p/(g + I0/T), smooth at g = 0
    double viscosity(double g, double p) const override {
        if (p <= 0) return muMin;
        return muMin + muS * p * yieldingTime(m, g) + (mu2 - muS) * p / (g + I0 / grainTime(p));
    }
    double slope(double g, double p) const override {
        if (p <= 0) return 0;
        const double sum = g + I0 / grainTime(p);
        return muS * p * yieldingTimeSlope(m, g) - (mu2 - muS) * p / (sum * sum);
    }

private:
    double grainTime(double p) const { return grainSize * std::sqrt(grainDensity / p); }
};

}  // namespace pfem
