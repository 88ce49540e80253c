// Cases with exact discrete solutions, through advance() with remeshing in every step.

#include <gtest/gtest.h>

#include "integration/smoothingDomains.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81;

TestCase tank(const std::string& condition) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                          water, "tank { type " + condition + "; }");
    c.tolerance(1e-10);
    return c;
}

double pressureError(const TestCase& c, double level) {
    const auto topology = c.topology();
    double error = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i))
            error = std::max(error, std::abs(c.state.nodes.p[i] - 1000 * g * (level - c.state.nodes.x[i][1])));
    return error / (1000 * g * level);
}

class Hydrostatic : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Hydrostatic, columnStaysAtRest) {
    const auto [wall, integration] = GetParam();
    TestCase c = tank(wall);
    c.controls.integration.integration = integration;
    c.start(1e-3);
    EXPECT_LT(pressureError(c, 0.5), 1e-8) << "consistent start";
    EXPECT_LT(largest(c.state.nodes.a), 1e-6) << "consistent start";
    const double volume = totalVolume<2>(c.state);
    for (int n = 0; n < 100; ++n) {
        const auto report = c.step(1e-3);
        ASSERT_EQ(report.rejected, 0);
    }
    std::cout << "pressure error " << pressureError(c, 0.5) << " rho g H, velocity " << largest(c.state.nodes.v)
              << " m/s\n";
    EXPECT_LT(pressureError(c, 0.5), 1e-6);
    EXPECT_LT(largest(c.state.nodes.v), 1e-8);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(walls, Hydrostatic,
                         testing::Combine(testing::Values("slip", "noSlip"), testing::Values("nodal", "elemental")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

// The column rests on an elastic bottom that has settled: here only the fluid's balance on a solid is looked at,
// the solid is stiff and weightless enough not to move.
class HydrostaticOnSolid : public testing::TestWithParam<const char*> {};

TEST_P(HydrostaticOnSolid, columnStaysAtRest) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } floor { type solid; material stiff; " + rectangle(0, -0.1, 1, 0) +
                              " patches { base { edges ((0 1) (1 2) (2 3) (3 0)); } } } );"
                              " walls ( left { points ((0 1) (0 0)); } right { points ((1 0) (1 1)); } );",
                          water + "stiff { type hypoelastic; rho 1; E 1e9; nu 0; }",
                          "base { type clamped; } left { type slip; } right { type slip; }");
    c.controls.integration.integration = GetParam();
    c.tolerance(1e-10);
    c.start(1e-3);
    for (int n = 0; n < 20; ++n) c.step(1e-3);
    std::cout << "pressure error " << pressureError(c, 0.5) << " rho g H, velocity " << largest(c.state.nodes.v)
              << " m/s\n";
    EXPECT_LT(pressureError(c, 0.5), 1e-6);
    EXPECT_LT(largest(c.state.nodes.v), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(, HydrostaticOnSolid, testing::Values("nodal", "elemental"),
                         [](const auto& test) { return std::string(test.param); });

// From rest, and with a velocity so that tau = 1/(... + rho |v|/h) differs from cell to cell.
class FreeFall : public testing::TestWithParam<std::tuple<double, const char*>> {};

TEST_P(FreeFall, blockFollowsTheParabola) {
    const auto [speed, stabilisation] = GetParam();
    const Vec<2> v0(0.7 * speed, 2 * speed);
    TestCase c =
        makeCase("meshSize 0.1; bodies ( water { type fluid; material water; velocity (" + std::to_string(v0[0]) + " " +
                     std::to_string(v0[1]) + "); " + rectangle(0, 0, 1, 0.5) + " } );",
                 water, "");
    c.tolerance(1e-12);
    c.controls.continuity.stabilisation = stabilisation;
    const Nodes<2> first = c.state.nodes;
    const double dt = 5e-3;
    c.start(dt);
    double start = 0;  // the consistent start resolves 1e-11 |v| / (1e-3 dt)
    for (const auto& a : c.state.nodes.a) start = std::max(start, (a - Vec<2>(0, -g)).norm());
    EXPECT_LT(start, speed == 0 ? 1e-9 : 1e-5);
    for (auto& a : c.state.nodes.a) a = Vec<2>(0, -g);
    std::fill(c.state.nodes.p.begin(), c.state.nodes.p.end(), 0.0);
    for (int n = 0; n < 60; ++n) c.step(dt);
    const double t = 60 * dt;
    ASSERT_EQ(c.state.nodes.id, first.id);
    double position = 0, velocity = 0;
    for (int i = 0; i < first.size(); ++i) {
        const Vec<2> x = first.X[i] + t * v0 + 0.5 * t * t * Vec<2>(0, -g);
        position = std::max(position, (c.state.nodes.x[i] - x).norm());
        velocity = std::max(velocity, (c.state.nodes.v[i] - v0 - Vec<2>(0, -g * t)).norm());
    }
    std::cout << "start " << start << " m/s2, position " << position << " m, velocity " << velocity << " m/s, pressure "
              << largest(c.state.nodes.p) << " Pa\n";
    EXPECT_LT(position, 1e-11);
    EXPECT_LT(velocity, 1e-10);
    EXPECT_LT(largest(c.state.nodes.p), 1e-6);  // of rho g h = 981 Pa
    EXPECT_NEAR(totalVolume<2>(c.state), 0.5, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(, FreeFall,
                         testing::Combine(testing::Values(0.0, 1.0), testing::Values("inertia", "bodyForce")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param) == 0 ? "fromRest_" : "thrown_") +
                                    std::get<1>(test.param);
                         });

// Isolated particles are in ballistic flight.
TEST(Particle, followsTheParabola) {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) + " } );", water, "");
    c.state.nodes.append(c.state.nodes, 0);
    c.state.nodes.id.back() = c.state.nextId++;
    c.state.nodes.x.back() = c.state.nodes.X.back() = Vec<2>(3, 3);
    c.state.nodes.v.back() = Vec<2>(1, 1);
    for (int n = 0; n < 20; ++n) c.step(0.01);
    EXPECT_LT((c.state.nodes.x.back() - Vec<2>(3.2, 3.2 - 0.5 * g * 0.04)).norm(), 1e-12);
}

// Couette flow between a fluid at rest and a moving body is not driven by anything: a uniform velocity along slip
// walls goes on for ever (no friction on slip walls, no damping of the rule for their velocities).
TEST(SlipWall, uniformFlowBetweenTwoWallsGoesOn) {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; velocity (1 0); " + rectangle(0, 0, 1, 0.5) +
            " } ); walls ( floor { points ((-0.5 0) (3 0)); } roof { points ((3 0.5) (-0.5 0.5)); } );",
        water, "floor { type slip; } roof { type slip; }", {0, 0});
    c.tolerance(1e-9);
    for (int n = 0; n < 20; ++n) c.step(2e-3);
    const auto topology = c.topology();
    double error = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i)) error = std::max(error, (c.state.nodes.v[i] - Vec<2>(1, 0)).norm());
    EXPECT_LT(error, 1e-9);
}

// A step that fails, in the iteration or after the remeshing, leaves the last good state.
TEST(FailedStep, leavesTheState) {
    for (const bool afterRemeshing : {false, true}) {
        TestCase c = tank("slip");
        c.start(1e-3);
        c.step(1e-3);
        if (afterRemeshing) {
            c.controls.convergence.maxVolumeChange = -1;
        } else {
            c.controls.convergence.tolU = 1e-300;
            c.controls.convergence.maxIterations = 3;
        }
        const State<2> before = c.state;
        EXPECT_THROW(c.step(1e-3), StepFailure);
        EXPECT_EQ(c.state.nodes.x, before.nodes.x);
        EXPECT_EQ(c.state.nodes.v, before.nodes.v);
        EXPECT_EQ(c.state.nodes.p, before.nodes.p);
        EXPECT_EQ(c.state.mesh.fluid.nodes, before.mesh.fluid.nodes);
        EXPECT_EQ(c.state.ledger.byName(), before.ledger.byName());
    }
}

TEST(VolumeCorrection, noFasterThanWithinAStep) {
    TestCase c = makeCase("meshSize 0.1; bodies ( pool { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                          water, "tank { type slip; }");
    c.controls.continuity.volumeCorrectionTime = 1e-9;
    c.start(1e-3);
    c.state.ledger.book(VolumeCause::reshaped, -5e-5);  // a loss of the past
    const double before = totalVolume<2>(c.state);
    c.step(1e-3);
    EXPECT_NEAR(c.state.ledger[VolumeCause::correction], 5e-5, 1e-9);
    EXPECT_GT(totalVolume<2>(c.state), before);
    EXPECT_LT(totalVolume<2>(c.state), before + 6e-5);
}

// Water that a dictionary lets run into a wall is deflected by an impulse, which takes energy and never gives any.
TEST(ImpulsiveStart, energyDoesNotGrow) {
    for (const char* speed : {"1", "-1"}) {
        TestCase c =
            makeCase("meshSize 0.05; bodies ( water { type fluid; material water; velocity (" + std::string(speed) +
                         " 0); " + rectangle(0, 0, 0.3, 0.5) + " } ); walls ( tank { points ((0 2) (0 0) (2 0)); } );",
                     water, "tank { type slip; }", {0, 0});
        const auto energy = [&] {
            const auto topology = c.topology();
            const auto patches = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x);
            double sum = 0;
            for (int i = 0; i < c.state.nodes.size(); ++i)
                sum += 500 * patches.volume[i] * c.state.nodes.v[i].squaredNorm();
            return sum;
        };
        const double before = energy();
        c.start(1e-3);
        const double after = energy();
        EXPECT_LT(after, before);
        EXPECT_GT(after, 0.1 * before);
        for (int n = 0; n < 20; ++n) c.step(1e-3);
        EXPECT_LT(energy(), 1.02 * after) << speed;
    }
}

}  // namespace
