#pragma once
// Casson's fluid (blood, chocolate): sqrt(tau) = sqrt(tau0) + sqrt(muInf g), with Papanastasiou's regularisation:
// mu = (sqrt(tau0 (1 - exp(-m g))/g) + sqrt(muInf))^2.

#include "dictionary/range.hpp"
#include "material/fluidLaw.hpp"
#include "material/papanastasiou.hpp"

namespace pfem {

class Casson : public FluidLawOf<Casson> {
public:
    double muInf = 0, tau0 = 0, m = 1000;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("muInf", muInf, "Pa s", "viscosity at high shear rates", positive);
        v.required("tau0", tau0, "Pa", "yield stress", nonNegative);
        v("m", m, "s", "Papanastasiou's time: shear rates below 1/m creep with a viscosity of some m tau0", positive);
    }
    double viscosity(double g, double) const override {
        const double root = std::sqrt(tau0 * yieldingTime(m, g)) + std::sqrt(muInf);
        return root * root;
    }
    double slope(double g, double) const override {
        const double y = std::sqrt(tau0 * yieldingTime(m, g));
        return y == 0 ? 0 : (y + std::sqrt(muInf)) * tau0 * yieldingTimeSlope(m, g) / y;
    }
};

}  // namespace pfem
