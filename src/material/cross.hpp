#pragma once
// Cross's fluid: mu = muInf + (mu0 - muInf)/(1 + (lambda g)^m).

#include <cmath>

#include "dictionary/range.hpp"
#include "material/fluidLaw.hpp"

namespace pfem {

class Cross : public FluidLawOf<Cross> {
public:
    double mu0 = 0, muInf = 0, lambda = 0, m = 1;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("mu0", mu0, "Pa s", "viscosity at rest", positive);
        v.required("muInf", muInf, "Pa s", "viscosity at high shear rates", nonNegative);
        v.required("lambda", lambda, "s", "time: at the shear rate 1/lambda the viscosity is the mean of both",
                   positive);
        v.required("m", m, "-", "exponent", positive);
    }
    double viscosity(double g, double) const override { return muInf + (mu0 - muInf) / (1 + std::pow(lambda * g, m)); }
    double slope(double g, double) const override {
        if (g == 0) return m == 1 ? -(mu0 - muInf) * lambda : 0;
        const double x = std::pow(lambda * g, m);
        return -(mu0 - muInf) * m * x / (g * (1 + x) * (1 + x));
    }
};

}  // namespace pfem
