// The laws and the wall of doc/developerGuide.md, against closed forms.

#include <cmath>
#include <cstdio>

#include "conditions/patchType.hpp"
#include "dictionary/dictionary.hpp"
#include "material/material.hpp"

namespace {

using namespace pfem;

int failures = 0;

void expectNear(const char* what, double value, double exact) {
    if (std::abs(value - exact) <= 1e-6 * std::abs(exact)) return;
    std::printf("%s: %.10g, not %.10g\n", what, value, exact);
    ++failures;
}

}  // namespace

int main() {
    const auto materials =
        readMaterials(Dictionary::parse("rubber { type gent; rho 1000; mu 1e5; Jm 20; nu 0.45; }"
                                        "oil { type prandtlEyring; rho 900; mu0 2; lambda 0.5; }",
                                        "materials"));
    Tensor<2> F;
    const double gamma = 1.5;
    F << 1, gamma, 0, 1;
    Stress<2> sigma = Stress<2>::Zero();
    materials[0].solid.law->stress(SolidPoints<2>{{&F, 1}, {&sigma, 1}, {}, {}, 1});
    expectNear("gent, shear stress", sigma[3], 1e5 * gamma / (1 - gamma * gamma / 20));
    const FluidLaw& oil = *materials[1].fluid.law;
    for (const double g : {1e-5, 0.3, 100.0}) {
        expectNear("prandtlEyring, stress", oil.viscosity(g, 0) * g, 4 * std::asinh(0.5 * g));
        const double d = 1e-4 * g;
        if (g > 1e-4)
            expectNear("prandtlEyring, slope", oil.slope(g, 0),
                       (oil.viscosity(g + d, 0) - oil.viscosity(g - d, 0)) / (2 * d));
    }
    for (const auto& type : patchTypes())
        if (type.name == "rough" && type.contactLine == Constraint::fixed) return failures;
    std::printf("no wall of type rough\n");
    return failures + 1;
}
