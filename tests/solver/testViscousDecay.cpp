// Taylor and Green's vortex in a unit box with slip walls: v = U (sin pi x cos pi y, -cos pi x sin pi y) decays with
// exp(-2 nu pi^2 t); normal velocity and shear stress vanish on the walls.

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

double energy(const TestCase& c) {
    double sum = 0;
    for (const auto& s : c.state.mesh.fluid.nodes)
        for (int node : s)
            sum += 0.5 * 1000 * simplexMeasure<2>(c.state.nodes.x, s) / 3 * c.state.nodes.v[node].squaredNorm();
    return sum;
}

/// Measured over exact rate of the energy's decay.
double decay(double h, double dt, const char* integration = "nodal") {
    constexpr double U = 0.1, nu = 0.01, endTime = 1;
    TestCase c = makeCase("meshSize " + std::to_string(h) + "; bodies ( oil { type fluid; material oil; " +
                              rectangle(0, 0, 1, 1) +
                              " } );"
                              " walls ( box { points ((0 0) (1 0) (1 1) (0 1)); closed yes; } );",
                          "oil { type newtonian; rho 1000; mu " + std::to_string(1000 * nu) + "; kappa 2.1e9; }",
                          "box { type slip; }", {0, 0});
    c.controls.integration.integration = integration;
    const double area = totalVolume<2>(c.state);
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const double x = M_PI * c.state.nodes.x[i][0], y = M_PI * c.state.nodes.x[i][1];
        c.state.nodes.v[i] = U * Vec<2>(std::sin(x) * std::cos(y), -std::cos(x) * std::sin(y));
        c.state.nodes.a[i] = -2 * nu * M_PI * M_PI * c.state.nodes.v[i];
        // pressure of the steady vortex carries the particles round: -rho v . grad v = grad p
        c.state.nodes.p[i] = 250 * U * U * (std::cos(2 * x) + std::cos(2 * y));
        c.state.nodes.a[i] += 0.5 * M_PI * U * U * Vec<2>(std::sin(2 * x), std::sin(2 * y));
    }
    const double first = energy(c);
    EXPECT_NEAR(first, 250 * U * U, 0.05 * 250 * U * U);
    int iterations = 0, steps = 0;
    for (; c.state.time.value < endTime - 0.5 * dt; ++steps) iterations += c.step(dt).step.iterations;
    const double rate = std::log(first / energy(c)) / endTime / (4 * nu * M_PI * M_PI);
    std::cout << "h " << h << ": decay " << rate << " of the exact one, iterations "
              << static_cast<double>(iterations) / steps << ", area " << totalVolume<2>(c.state) / area - 1 << "\n";
    EXPECT_NEAR(totalVolume<2>(c.state), area, 1e-6 * area);
    return rate;
}

TEST(ViscousDecay, taylorGreen) {
    const double coarse = decay(0.1, 0.02), fine = decay(0.05, 0.01);
    EXPECT_NEAR(fine, 1, 0.02);
    EXPECT_LT(std::abs(fine - 1), std::abs(coarse - 1));
}

// Elements see all of a velocity's gradient, patches of nodes only its mean: more viscous forces, the same limit.
TEST(ViscousDecay, taylorGreenElemental) {
    const double fine = decay(0.05, 0.01, "elemental");
    EXPECT_NEAR(fine, 1, 0.02);
    EXPECT_GT(fine, decay(0.05, 0.01));
}

}  // namespace
