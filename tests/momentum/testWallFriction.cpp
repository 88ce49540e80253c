// Friction of walls along which water slides: tau_w = rho c_f |u| u/2.

#include <gtest/gtest.h>

#include "functions/storedEnergy.hpp"
#include "momentum/wallFriction.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double cf = 0.02, rho = 1000;

/// 1 m of water, 0.2 m deep, without gravity: it slides over the floor at u, all at one speed.
TestCase slidingWater(double u, const std::string& floor = "floor { type slip; friction 0.02; }") {
    TestCase c = makeCase("meshSize 0.05; bodies ( water { type fluid; material water; velocity (" + std::to_string(u) +
                              " 0); " + rectangle(1, 0, 2, 0.2) + " } ); walls ( floor { points ((0 0) (4 0)); } );",
                          water, floor, {0, 0});
    return c;
}

Vec<2> total(const Points<2>& force) {
    Vec<2> sum = Vec<2>::Zero();
    for (const auto& f : force) sum += f;
    return sum;
}

Points<2> frictionOf(const TestCase& c) {
    Points<2> force(c.state.nodes.size(), Vec<2>::Zero());
    addWallFriction<2>(c.problem, c.state.mesh.fluid, c.topology(), c.state.nodes, force);
    return force;
}

TEST(WallFriction, isTheStressTimesTheWettedLength) {
    TestCase c = slidingWater(3);
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);  // nodes land on the wall
    const Vec<2> force = total(frictionOf(c));
    EXPECT_NEAR(force[0], -0.5 * rho * cf * 9, 1e-9 * rho);
    EXPECT_NEAR(force[1], 0, 1e-12);
    for (auto& v : c.state.nodes.v) v = {-3, 0};  // the other way
    EXPECT_NEAR(total(frictionOf(c))[0], 0.5 * rho * cf * 9, 1e-9 * rho);
}

// Floor and sides of a box that water fills up to 0.2 m, each with the part of the velocity that is along it.
TEST(WallFriction, inSpaceEachWallTakesWhatIsAlongIt) {
    TestCase3 c = boxOfWater({0.4, 0.3, 0.2}, {0.4, 0.3, 0.4}, 0.1, "slip; friction 0.02");
    c.state.nodes.v.assign(c.state.nodes.v.size(), Vec<3>(3, 1, -2));
    const auto friction = [](const Vec<3>& u, double area) { return Vec<3>(-0.5 * rho * cf * u.norm() * area * u); };
    const Vec<3> exact =
        friction({3, 1, 0}, 0.4 * 0.3) + friction({3, 0, -2}, 2 * 0.4 * 0.2) + friction({0, 1, -2}, 2 * 0.3 * 0.2);
    Points<3> force(c.state.nodes.size(), Vec<3>::Zero());
    addWallFriction<3>(c.problem, c.state.mesh.fluid, c.topology(), c.state.nodes, force);
    Vec<3> sum = Vec<3>::Zero();
    for (const auto& f : force) sum += f;
    EXPECT_LT((sum - exact).norm(), 1e-9 * rho);
}

TEST(WallFriction, countsVelocityRelativeToTheWall) {
    TestCase c = slidingWater(3, "floor { type slip; friction 0.02; motion { velocity (1 0 0); } }");
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    EXPECT_NEAR(total(frictionOf(c))[0], -0.5 * rho * cf * 4, 1e-6 * rho);
}

// u' = - c_f u^2/b of water far from everything else: u = u0/(1 + c_f u0 t/b)
TEST(SideWalls, slowTheFlow) {
    TestCase c = slidingWater(3, "floor { type slip; } glass { type sideWalls; width 0.1; friction 0.02; }");
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    c.tolerance(1e-9);
    const double dt = 2e-3;
    c.start(dt);
    for (int k = 0; k < 25; ++k) c.step(dt);
    const double u = 3 / (1 + 0.02 * 3 * 0.05 / 0.1);
    EXPECT_NEAR(c.state.time.value, 0.05, 1e-12);
    double worst = 0, mean = 0, mass = 0;
    for (const auto& s : c.state.mesh.fluid.nodes)
        for (int node : s) {
            const double share = simplexMeasure<2>(c.state.nodes.x, s) / 3, error = c.state.nodes.v[node][0] - u;
            mass += share;
            mean += share * error;
            worst = std::max(worst, std::abs(error));
        }
    EXPECT_NEAR(mean / mass, 0, 1e-4 * u);
    EXPECT_LT(worst, 2e-3 * u);
}

TEST(SideWalls, whatTheyTakeIsDissipated) {
    TestCase c = slidingWater(3, "floor { type slip; } glass { type sideWalls; width 0.1; friction 0.02; }");
    EXPECT_NEAR(energyPowers<2>(c.problem, c.controls, c.state).viscous, rho * 0.2 * 0.02 * 27 / 0.1,
                1e-9 * rho);  // rho V c_f u^3/b
}

// u' = - r u: half way in, r = 8 0.5^2 1/s; without gravity and pressure each node for itself.
TEST(Damping, bringsWaterToRest) {
    const std::string zone = "floor { type slip; } sponge { type damping; from (1 0 0); to (2 0 0); rate 8; ";
    TestCase c = slidingWater(3, zone + "exponent 0; velocity (1 0 0); }");
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    c.tolerance(1e-9);
    c.start(2e-3);
    for (int k = 0; k < 25; ++k) c.step(2e-3);
    const double u = 1 + 2 * std::exp(-8 * 0.05);
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (c.topology().wet(i)) {
            EXPECT_NEAR(c.state.nodes.v[i][0], u, 1e-4);
        }
    const DampingZone<2> grows = slidingWater(3, zone + "}").problem.conditions.damping.at(0);
    EXPECT_EQ(grows.at({0.9, 5}), 0);
    EXPECT_NEAR(grows.at({1.5, 5}), 2, 1e-12);
    EXPECT_NEAR(grows.at({7, -5}), 8, 1e-12);
}

TEST(Damping, whatItTakesIsDissipated) {
    TestCase c = slidingWater(3, "floor { type slip; } sponge { type damping; from (0 0 0); to (1 0 0); rate 8; }");
    EXPECT_NEAR(energyPowers<2>(c.problem, c.controls, c.state).viscous, rho * 0.2 * 8 * 9, 1e-9 * rho);
}

TEST(SideWalls, badWords) {
    const auto fails = [](const std::string& entry) {
        EXPECT_THROW(slidingWater(3, "floor { type slip; } " + entry), UserError) << entry;
    };
    fails("glass { type sideWalls; friction 0.02; }");
    fails("glass { type sideWalls; width 0.1; }");
    fails("glass { type sideWalls; width 0; friction 0.02; }");
    fails("glass { type sideWalls; width 0.1; friction -1; }");
    fails("glass { type slip; }");
    fails("sponge { type damping; from (0 0 0); to (1 0 0); }");
    fails("sponge { type damping; from (0 0 0); to (0 0 0); rate 1; }");
    fails("sponge { type damping; from (0 0 0); to (1 0 0); rate -1; }");
    fails("sponge { type damping; from (0 0 0); to (1 0 1); rate 1; }");
}

TEST(WallFriction, slowsTheFlow) {
    TestCase c = slidingWater(3);
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    c.tolerance(1e-9);
    const double dt = 1e-3;
    c.start(dt);  // trapezoidal steps need the acceleration at their start
    const auto momentum = [&] {
        double sum = 0;
        for (const auto& s : c.state.mesh.fluid.nodes)
            for (int node : s) sum += rho * simplexMeasure<2>(c.state.nodes.x, s) / 3 * c.state.nodes.v[node][0];
        return sum;
    };
    double before = momentum();
    for (int k = 0; k < 4; ++k) {
        const double drag = total(frictionOf(c))[0];
        c.step(dt);
        const double lost = momentum() - before;
        EXPECT_NEAR(lost, 0.5 * dt * (drag + total(frictionOf(c))[0]), 0.01 * dt * 90) << k;
        before = momentum();
    }
}

}  // namespace
