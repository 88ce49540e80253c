// Gravity and tractions that depend on time, initial velocities that depend on the place.

#include <gtest/gtest.h>

#include <cmath>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

// A block of water in free flight under g(t) = (3 t, -6 t): after a time t it has moved by (t^3/2, -t^3).
TEST(Gravity, dependsOnTime) {
    double last = 0;
    for (const double dt : {0.02, 0.01}) {
        TestCase c =
            makeCase("meshSize 0.2; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.6) + " } );",
                     water, "", {0, 0});
        c.problem.gravityOverTime =
            readFunction1<Eigen::Vector3d>(Dictionary::parse("value polynomial (((3 -6 0) (1 1 1))); "), "value");
        c.tolerance(1e-12);
        c.start(dt);
        const int steps = static_cast<int>(std::lround(0.4 / dt));
        for (int n = 0; n < steps; ++n) c.step(dt);
        double error = 0;
        for (int i = 0; i < c.state.nodes.size(); ++i) {
            error = std::max(error, (c.state.nodes.x[i] - c.state.nodes.X[i] - Vec<2>(0.032, -0.064)).norm());
            EXPECT_LT((c.state.nodes.v[i] - Vec<2>(0.24, -0.48)).norm(), 0.15 * dt);
        }
        EXPECT_LT(error, last == 0 ? 1e-3 : 0.4 * last);
        last = error;
    }
}

// A bar pulled slowly: its stress follows the traction.
TEST(Traction, dependsOnTime) {
    TestCase c = makeCase(
        "meshSize 0.25; bodies ( bar { type solid; material rubber; " + rectangle(0, 0, 1, 0.25) +
            " patches { left { edges ((3 0)); } right { edges ((1 2)); } } } );",
        "rubber { type hypoelastic; rho 1; E 1e6; nu 0; }",
        "left { type symmetry; } right { type traction; traction table ((0 (0 0 0)) (1 (1000 0 0))); }", {0, 0});
    c.tolerance(1e-10);
    c.controls.timeIntegration.gamma = 1;
    c.start(0.02);
    for (int n = 0; n < 60; ++n) {
        c.step(0.02);
        const double wanted = 1000 * std::min(c.state.time.value, 1.0);
        for (int i = 0; i < c.state.nodes.size(); ++i)
            EXPECT_NEAR(c.state.nodes.sigma[i][0], wanted, 20) << c.state.time.value;
    }
}

TEST(InitialVelocity, dependsOnThePlace) {
    const TestCase c = makeCase(
        "meshSize 0.2; bodies ( water { type fluid; material water; velocity expression (\"-2*y\" \"2*x + 1\"); " +
            rectangle(0, 0, 1, 0.6) + " } );",
        water, "");
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const Vec<2>& x = c.state.nodes.x[i];
        EXPECT_LT((c.state.nodes.v[i] - Vec<2>(-2 * x[1], 2 * x[0] + 1)).norm(), 1e-14);
    }
    for (const char* wrong : {"expression (\"x\");", "formula (\"x\" \"y\");", "expression (\"z\" \"0\");"})
        EXPECT_THROW(makeCase("meshSize 0.2; bodies ( water { type fluid; material water; velocity " +
                                  std::string(wrong) + rectangle(0, 0, 1, 0.6) + " } );",
                              water, ""),
                     UserError)
            << wrong;
}

// A solid disc's worth of rotation: a free block set into rigid rotation keeps on turning without shear.
TEST(InitialVelocity, rigidRotationGoesOn) {
    TestCase c =
        makeCase("meshSize 0.1; bodies ( block { type solid; material stiff; velocity expression (\"-3*y\" \"3*x\"); " +
                     rectangle(-0.2, -0.2, 0.2, 0.2) + " } );",
                 "stiff { type hypoelastic; rho 1000; E 1e8; nu 0.3; }", "", {0, 0});
    c.start(1e-3);
    for (int n = 0; n < 100; ++n) c.step(1e-3);
    const int corner = nearestNode(c.state.nodes.X, {0.2, 0.2});
    const Vec<2> turned(0.2 * (std::cos(0.3) - std::sin(0.3)), 0.2 * (std::cos(0.3) + std::sin(0.3)));
    EXPECT_LT((c.state.nodes.x[corner] - turned).norm(), 1e-4);
}

}  // namespace
