// Walls that are not parallel to an axis: what happens must not depend on how the tank is turned. On such walls no
// three nodes are on one line to the last bit, and the reactions leave round-off along the normal.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TestCase tank(const std::string& vertices) {
    return makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + vertices +
                        " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                    water, "tank { type slip; }");
}

void turn(TestCase& c, double degrees) {
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(degrees * M_PI / 180).toRotationMatrix();
    for (auto* points : {&c.state.nodes.x, &c.state.nodes.X, &c.state.nodes.v, &c.state.nodes.a})
        for (auto& x : *points) x = R * x;
    c.problem.gravity = R * c.problem.gravity;
}

class InclinedWalls : public testing::TestWithParam<double> {};

TEST_P(InclinedWalls, columnStaysAtRest) {
    TestCase c = tank(rectangle(0, 0, 1, 0.5));
    c.tolerance(1e-10);
    turn(c, GetParam());
    c.start(1e-3);
    const double volume = totalVolume<2>(c.state);
    for (int n = 0; n < 50; ++n) ASSERT_EQ(c.step(1e-3).rejected, 0);
    const auto topology = c.topology();
    const double rhoG = 1000 * c.problem.gravity.norm();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const double depth = 0.5 + c.state.nodes.x[i].dot(c.problem.gravity.normalized());
        if (topology.wet(i)) {
            EXPECT_NEAR(c.state.nodes.p[i], rhoG * depth, 1e-6 * rhoG);
        }
    }
    EXPECT_LT(largest(c.state.nodes.v), 1e-8);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-9);
}

TEST_P(InclinedWalls, columnCollapsesAsInAnUprightTank) {
    TestCase upright = tank(rectangle(0, 0, 0.3, 0.5)), turned = upright;
    turn(turned, GetParam());
    for (TestCase* c : {&upright, &turned}) {
        c->start(2e-3);
        for (int n = 0; n < 75; ++n) ASSERT_EQ(c->step(2e-3).rejected, 0);
        for (const auto& s : c->state.mesh.fluid.nodes)
            EXPECT_GT(simplexMeasure<2>(c->state.nodes.x, s), 1e-9 * 0.05 * 0.05);
    }
    turn(turned, -GetParam());
    const auto front = [](const TestCase& c) {
        double x = 0;
        const auto topology = c.topology();
        for (int i = 0; i < c.state.nodes.size(); ++i)
            if (topology.wet(i)) x = std::max(x, c.state.nodes.x[i][0]);
        return x;
    };
    EXPECT_GT(front(upright), 0.4);
    EXPECT_NEAR(front(turned), front(upright), 0.01 * front(upright));
    EXPECT_NEAR(totalVolume<2>(turned.state), totalVolume<2>(upright.state), 1e-3 * totalVolume<2>(upright.state));
}

INSTANTIATE_TEST_SUITE_P(degrees, InclinedWalls, testing::Values(30.0, -77.0), [](const auto& test) {
    return (test.param < 0 ? "minus" : "plus") + std::to_string(static_cast<int>(std::abs(test.param)));
});

}  // namespace
