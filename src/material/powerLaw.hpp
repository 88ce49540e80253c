#pragma once
// Power law (Ostwald and de Waele): mu = k g^(n-1), between muMin and muMax.

#include <algorithm>
#include <cmath>

#include "dictionary/range.hpp"
#include "material/fluidLaw.hpp"

namespace pfem {

class PowerLaw : public FluidLawOf<PowerLaw> {
public:
    double k = 0, n = 1, muMin = 0, muMax = 1e6;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("n", n, "-", "flow index: below 1 shear thinning, above 1 thickening", positive);
        v.required("k", k, "Pa s^n", "consistency", positive);
        v.required("muMin", muMin, "Pa s", "least viscosity", nonNegative);
        v.required("muMax", muMax, "Pa s", "largest viscosity", positive);
    }
    double viscosity(double g, double) const override {
        return std::clamp(unlimited(g), muMin, std::max(muMin, muMax));
    }
    double slope(double g, double) const override {
        const double mu = unlimited(g);
        return g > 0 && mu > muMin && mu < muMax ? (n - 1) * mu / g : 0;
    }

private:
    double unlimited(double g) const { return n == 1 ? k : g > 0 ? k * std::pow(g, n - 1) : n < 1 ? muMax : muMin; }
};

}  // namespace pfem
