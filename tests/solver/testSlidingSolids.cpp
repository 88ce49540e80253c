// Solids at walls without contact: their nodes are their own.

#include <gtest/gtest.h>

#include "solver/checkProblem.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

// Water on an elastic column whose sides slide along planes of symmetry; the walls of the water end where it begins.
TEST(SlidingSolids, theEdgeOfAColumnSlidesAlongTheWalls) {
    TestCase c = makeCase(
        "meshSize 0.0125; bodies ( column { type solid; material soft; " + rectangle(0, 0, 0.05, 0.25) +
            " patches { base { edges ((0 1)); } sides { edges ((1 2) (3 0)); } } } water { type fluid; material "
            "water; " +
            rectangle(0, 0.25, 0.05, 1) +
            " } ); walls ( left { points ((0 1.2) (0 0.25)); } right { points ((0.05 0.25) (0.05 1.2)); } );",
        "water { type newtonian; rho 1000; mu 0; kappa 2.1e9; } soft { type hypoelastic; rho 1500; E 2.3e5; nu 0.4; }",
        "left { type slip; } right { type slip; } base { type clamped; } sides { type symmetry; }", {0, -10});
    const double dt = 1e-3;
    c.start(dt);
    std::array<Id, 3> id{};
    for (int k = 0; k < 3; ++k) id[k] = c.state.nodes.id[nearestNode(c.state.nodes.X, {0.025 * k, 0.25})];
    std::vector<double> t, u;
    double spread = 0;
    for (int n = 0; n < 300; ++n) {
        ASSERT_EQ(c.step(dt).rejected, 0);
        std::array<double, 3> y{};
        for (int k = 0; k < 3; ++k) y[k] = c.state.nodes.x[nodeOf(c.state.nodes, id[k])][1] - 0.25;
        t.push_back(c.state.time.value);
        u.push_back(y[1]);
        spread = std::max({spread, std::abs(y[0] - y[1]), std::abs(y[2] - y[1])});
    }
    const auto fit = fitHarmonic(t, u, 35, 60);
    std::cout << "period " << 2 * M_PI / fit.omega << " s, mean " << fit.mean << " m, amplitude " << fit.amplitude
              << " m, over the width " << spread << " m\n";
    EXPECT_NEAR(2 * M_PI / fit.omega, 0.13265, 0.01 * 0.13265);
    EXPECT_NEAR(fit.mean, -4.755e-3, 0.02 * 4.755e-3);
    EXPECT_NEAR(fit.amplitude, 4.755e-3, 0.02 * 4.755e-3);
    EXPECT_LT(spread, 0.02 * 4.755e-3);
}

// A free foot on the floor: the floor goes on under it, and the foot moves.
TEST(SlidingSolids, theFootOfAGateLeavesTheFloor) {
    TestCase c = makeCase(
        "meshSize 0.01; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.1, 0.14) +
            " } gate { type solid; material rubber; meshSize 0.005; " + rectangle(0.1, 0, 0.12, 0.14) +
            " patches { top { edges ((2 3)); } } } ); walls ( tank { points ((0 0.3) (0 0) (1.2 0) (1.2 0.3)); } );",
        water + "rubber { type hypoelastic; rho 1100; E 1e6; nu 0.4; }", "tank { type slip; } top { type clamped; }");
    double floor = 0;
    for (const auto& face : c.state.mesh.patches[0].faces)
        if (c.state.nodes.x[face[0]][1] == 0 && c.state.nodes.x[face[1]][1] == 0)
            floor += c.state.nodes.x[face[1]][0] - c.state.nodes.x[face[0]][0];
    EXPECT_NEAR(floor, 1.2, 1e-12);
    c.start(5e-4);
    const Id foot = c.state.nodes.id[nearestNode(c.state.nodes.X, {0.12, 0})];
    for (int n = 0; n < 60; ++n) c.step(5e-4);
    const int i = nodeOf(c.state.nodes, foot);
    EXPECT_GT(c.state.nodes.x[i][0] - c.state.nodes.X[i][0], 1e-3);
}

// Half a wedge whose clamped ends move down, one of them along the wall of the axis.
TEST(SlidingSolids, aClampedEndMovesAlongAWall) {
    const std::string conditions =
        "axis { type slip; } tank { type slip; } apex { type clamped; motion { velocity (0 -3 0); } } outer { type "
        "clamped; motion { velocity (0 -3 0); } }";
    TestCase c = makeCase(
        "meshSize 0.04; bodies ( water { type fluid; material water; vertices ((0 -0.4) (0.8 -0.4) (0.8 0) (0 0)); } "
        "plate "
        "{ type solid; material aluminium; meshSize 0.02; velocity (0 -3); vertices ((0 0.005) (0.4 0.075) (0.39 "
        "0.135) (0 "
        "0.066)); patches { apex { edges ((3 0)); } outer { edges ((1 2)); } } } ); walls ( axis { points ((0 0.3) (0 "
        "-0.4)); moving true; } tank { points ((0 -0.4) (0.8 -0.4) (0.8 0.3)); } );",
        water + "aluminium { type hypoelastic; rho 2700; E 6e9; nu 0.34; }", conditions);
    EXPECT_NO_THROW(
        checkConditions<2>(Dictionary::parse(conditions, "boundaryConditions"), c.problem.conditions, c.state));
    const Id apex = c.state.nodes.id[nearestNode(c.state.nodes.X, {0, 0.005})];
    c.start(1e-4);
    for (int n = 0; n < 40; ++n) ASSERT_EQ(c.step(1e-4).rejected, 0);
    const Vec<2> x = c.state.nodes.x[nodeOf(c.state.nodes, apex)];
    EXPECT_LT((x - Vec<2>(0, 0.005 - 3 * 4e-3)).norm(), 1e-12);
    EXPECT_LT(c.state.nodes.v[nodeOf(c.state.nodes, apex)][1], -2.9);
}

}  // namespace
