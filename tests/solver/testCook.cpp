// Cook's membrane, nearly incompressible: corners (0 0) (48 44) (48 60) (0 44), clamped on the left, a shear force of 1
// on the right, plane strain, mu = 0.375. The middle of the loaded edge moves by 16.442 (value of the literature).

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double published = 16.442;

/// Linear static solution from one long step of backward Euler under a tiny load: u = dt v.
double middle(int n, double nu, const std::string& integration, const std::string& formulation,
              const std::string& law = "paper", const std::string& ofSolids = "asFluid") {
    constexpr double load = 1e-6, dt = 1;
    const std::string cells = "(" + std::to_string(n) + " " + std::to_string(n) + ")";
    TestCase c = makeCase(
        "meshSize 5; bodies ( membrane { type solid; material rubber;"
        " vertices ((0 0) (48 44) (48 60) (0 44)); pattern oneWay; cells " +
            cells + "; patches { base { edges ((3 0)); } end { edges ((1 2)); } } } );",
        law == "mooneyRivlin"
            ? "rubber { type mooneyRivlin; rho 1e-9; C10 0.125; C01 0.0625; nu " + std::to_string(nu) + "; }"
            : "rubber { type hypoelastic; rho 1e-9; E " + std::to_string(0.75 * (1 + nu)) + "; nu " +
                  std::to_string(nu) + "; }",
        "base { type clamped; } end { type traction; traction (0 1 0); }", {0, 0});
    for (auto& t : c.problem.conditions.traction) t = {0, load / 16};
    c.controls.integration.integration = integration;
    c.controls.solid = {.formulation = formulation, .damping = 0, .integration = ofSolids};
    if (law != "mooneyRivlin") useUpdate(c.problem, law);
    c.controls.timeIntegration.gamma = 1;
    c.tolerance(1e-9);
    c.step(dt);
    const int node = nearestNode(c.state.nodes.X, {48, 52});
    // the hyperelastic stress is that of the positions, x - X = dt v/2; the others have the strain dt grad v
    const double u =
        (law != "paper" ? c.state.nodes.x[node][1] - c.state.nodes.X[node][1] : dt * c.state.nodes.v[node][1]) / load;
    std::cout << "nu " << nu << " " << integration << " " << formulation << " " << law << " " << n << " x " << n << ": "
              << u << "\n";
    return u;
}

/// Richardson's extrapolation of three values on meshes of 16, 32 and 64.
double extrapolated(double a, double b, double c) { return c + (c - b) / ((b - a) / (c - b) - 1); }

TEST(CooksMembrane, nodalAndMixedConvergeWhileElementalLocks) {
    const auto study = [](const char* integration, const char* formulation, double last, const char* law = "paper",
                          double nu = 0.4999) {
        std::array<double, 3> u;
        for (int k = 0; k < 3; ++k) u[k] = middle(16 << k, nu, integration, formulation, law);
        EXPECT_NEAR(u[2], published, last * published);
        EXPECT_LT(std::abs(u[2] - published), std::abs(u[1] - published));
        EXPECT_NEAR(extrapolated(u[0], u[1], u[2]), published, 5e-3 * published);
    };
    study("nodal", "velocity", 5e-3);
    study("elemental", "velocityPressure", 2e-2);
    study("elemental", "velocityPressure", 2e-2, "neoHookean");
    study("elemental", "velocityPressure", 2e-2, "mooneyRivlin", 0.4995);
    EXPECT_LT(middle(64, 0.4999, "elemental", "velocity"), 0.4 * published);
}

// Compressible: all three tend to one value.
TEST(CooksMembrane, compressible) {
    const double nodal = middle(32, 0.25, "nodal", "velocity");
    const double elemental = middle(32, 0.25, "elemental", "velocity");
    const double mixed = middle(32, 0.25, "elemental", "velocityPressure");
    EXPECT_GT(nodal, elemental);
    EXPECT_NEAR(nodal, elemental, 0.05 * nodal);
    EXPECT_GT(mixed, elemental);
    EXPECT_LT(mixed, nodal);
}

// What `solid` says of the integration counts for solids, whatever fluids have.
TEST(CooksMembrane, integrationOfSolidsAlone) {
    for (const char* formulation : {"velocity", "velocityPressure"}) {
        const double nodal = middle(16, 0.4, "nodal", formulation), stiff = middle(16, 0.4, "elemental", formulation);
        EXPECT_NE(nodal, stiff);
        EXPECT_EQ(middle(16, 0.4, "nodal", formulation, "paper", "elemental"), stiff);
        EXPECT_EQ(middle(16, 0.4, "elemental", formulation, "paper", "nodal"), nodal);
    }
}

}  // namespace
