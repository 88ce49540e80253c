#pragma once
// Carreau and Yasuda's fluid: mu = muInf + (mu0 - muInf) (1 + (lambda g)^a)^((n-1)/a); a = 2: Carreau's.

#include <cmath>

#include "dictionary/range.hpp"
#include "material/fluidLaw.hpp"

namespace pfem {

class Carreau : public FluidLawOf<Carreau> {
public:
    double mu0 = 0, muInf = 0, lambda = 0, n = 1, a = 2;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("mu0", mu0, "Pa s", "viscosity at rest", positive);
        v.required("muInf", muInf, "Pa s", "viscosity at high shear rates", nonNegative);
        v.required("lambda", lambda, "s", "time: above 1/lambda the viscosity falls", positive);
        v.required("n", n, "-", "flow index", positive);
        v("a", a, "-", "Yasuda's exponent: how sharply it begins to fall", positive);
    }
    double viscosity(double g, double) const override {
        return muInf + (mu0 - muInf) * std::pow(1 + std::pow(lambda * g, a), (n - 1) / a);
    }
    double slope(double g, double) const override {
        if (g == 0) return a > 1 ? 0 : (mu0 - muInf) * (n - 1) * lambda;
        const double x = std::pow(lambda * g, a);
        return (mu0 - muInf) * (n - 1) * x / g * std::pow(1 + x, (n - 1) / a - 1);
    }
};

}  // namespace pfem
