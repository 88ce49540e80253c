// Walls that move by a prescribed motion: accelerated tanks, a piston, a gate.

#include <gtest/gtest.h>

#include <numbers>

#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "solver/checkProblem.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, pi = std::numbers::pi;

/// Largest deviation of p from rho (g - a) . (x - x_top) + const over the fluid's nodes, in rho g H.
double pressureError(const TestCase& c, const Vec<2>& acceleration, double H) {
    const auto topology = c.topology();
    const Vec<2> slope = 1000 * (c.problem.gravity - acceleration);
    double low = 1e300, high = -1e300;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        if (!topology.wet(i)) continue;
        const double rest = c.state.nodes.p[i] - slope.dot(c.state.nodes.x[i]);
        low = std::min(low, rest);
        high = std::max(high, rest);
    }
    return (high - low) / (1000 * g * H);
}

/// Largest deviation of a wet node's velocity from `v`.
double velocityError(const TestCase& c, const Vec<2>& v) {
    const auto topology = c.topology();
    double error = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i)) error = std::max(error, (c.state.nodes.v[i] - v).norm());
    return error;
}

TestCase closedTank(const std::string& kind, const std::string& motion) {
    return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                        " } ); walls ( tank { closed true; points ((0 0) (1 0) (1 0.5) (0 0.5)); } );",
                    water, "tank { type " + kind + "; motion { " + motion + " } }");
}

// Uniform acceleration from rest: the water goes along as a block, with grad p = rho (g - a) to the tolerance.
class AcceleratedTank : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(AcceleratedTank, pressureIsExact) {
    const auto [kind, stabilisation] = GetParam();
    TestCase c = closedTank(kind, "displacement polynomial (((1.5 0.5 0) (2 2 0)));");
    c.controls.continuity.stabilisation = stabilisation;
    c.tolerance(1e-11);
    const Vec<2> a(3, 1);
    c.start(5e-3);
    EXPECT_LT(pressureError(c, a, 0.5), 1e-6) << "at the start";
    for (int n = 0; n < 40; ++n) ASSERT_EQ(c.step(5e-3).rejected, 0);
    std::cout << "pressure error " << pressureError(c, a, 0.5) << " rho g H, velocity " << velocityError(c, 0.2 * a)
              << " m/s\n";
    EXPECT_LT(pressureError(c, a, 0.5), 1e-6);
    EXPECT_LT(velocityError(c, 0.2 * a), 1e-8);
    EXPECT_NEAR(totalVolume<2>(c.state), 0.5, 1e-9);
    EXPECT_NEAR(c.state.nodes.x[nearestNode(c.state.nodes.X, {0, 0})][0], 0.06, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(, AcceleratedTank,
                         testing::Combine(testing::Values("slip", "noSlip"),
                                          testing::Values("projection", "inertia", "bodyForce")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

// Shaken sinusoidally: exact up to the time step; an error that falls with it.
TEST(ShakenTank, pressureConverges) {
    double last = 0;
    for (const double dt : {0.01, 0.005, 0.0025}) {
        TestCase c = closedTank("slip", "displacement { type sine; frequency 2; start 0.125; scale (0.05 0.01 0); }");
        c.tolerance(1e-9);
        c.start(dt);
        double error = 0;
        const double omega = 4 * pi;
        for (int n = 1; n * dt < 0.501; ++n) {
            c.step(dt);
            const double phase = omega * n * dt,
                         middle = omega * (n - 0.5) * dt;  // p is that of the middle of the step
            error = std::max(error, pressureError(c, omega * omega * std::cos(middle) * Vec<2>(0.05, 0.01), 0.5));
            EXPECT_LT(velocityError(c, omega * std::sin(phase) * Vec<2>(0.05, 0.01)), 0.01);
        }
        std::cout << "dt " << dt << ", pressure error " << error << " rho g H\n";
        EXPECT_LT(error, last == 0 ? 0.05 : 0.35 * last);
        EXPECT_NEAR(totalVolume<2>(c.state), 0.5, 1e-9);
        last = error;
    }
}

// An open tank under steady acceleration a: the surface stands at the slope -a/g and stays there.
TEST(OpenTank, inclinedSurfaceStays) {
    TestCase c = tiltedTank("0.1", "type slip; motion { displacement polynomial (((0.981 0 0) (2 0 0))); }");
    c.tolerance(1e-11);
    const Vec<2> a(0.2 * g, 0);
    c.start(5e-3);
    for (int n = 0; n < 60; ++n) ASSERT_EQ(c.step(5e-3).rejected, 0);
    EXPECT_LT(pressureError(c, a, 0.5), 1e-6);
    EXPECT_LT(velocityError(c, 0.3 * a), 1e-7);
    EXPECT_NEAR(totalVolume<2>(c.state), 0.5, 1e-9);
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.freeSurface[i]) {
            EXPECT_NEAR(c.state.nodes.p[i], 0, 1e-2);
        }
}

// A tank that glides carries its water as if at rest; started with walls and water at the same speed.
TEST(GlidingTank, isAtRestInItsFrame) {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; velocity (2 0); " + rectangle(0, 0, 1, 0.5) +
            " } ); walls ( left { points ((0 1) (0 0)); } rest { points ((0 0) (1 0) (1 1)); } );",
        water, "left { type slip; motion { velocity (2 0 0); } } rest { type slip; motion { velocity (2 0 0); } }");
    c.tolerance(1e-11);
    c.start(5e-3);
    for (int n = 0; n < 40; ++n) ASSERT_EQ(c.step(5e-3).rejected, 0);
    EXPECT_LT(pressureError(c, {0, 0}, 0.5), 1e-6);
    EXPECT_LT(velocityError(c, {2, 0}), 1e-8);
    EXPECT_NEAR(totalVolume<2>(c.state), 0.5, 1e-9);
}

TestCase pistonTank(const std::string& motion) {
    return makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.3) +
                        " } ); walls ( piston { moving true; points ((0 0.6) (0 0)); } tank { points ((-0.3 0) (1 0) "
                        "(1 0.6)); } );",
                    "water { type newtonian; rho 1000; mu 0; kappa 2.1e9; }",
                    "tank { type slip; } piston { type slip; motion { " + motion + " } }");
}

double levelAt(const TestCase& c, double x) {
    const auto topology = c.topology();
    double level = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.freeSurface[i] && std::abs(c.state.nodes.x[i][0] - x) < 1e-6)
            level = std::max(level, c.state.nodes.x[i][1]);
    return level;
}

// Linear theory of a tank (length L, depth H) whose left wall moves with velocity U: modes cos(k_n x), k_n = n pi/L,
// obey eta_n'' + w_n^2 eta_n = (2 tanh(k_n H)/(k_n L)) U', the mean level rises by H s/L.
TEST(Piston, levelFollowsLinearTheory) {
    const double L = 1, H = 0.3, s = 0.005, Omega = 2 * pi * 0.6;
    TestCase c = pistonTank("displacement expression (\"0.005*(1 - cos(2*pi*0.6*t))\" \"0\" \"0\");");
    const double dt = 0.01, volume = totalVolume<2>(c.state);
    c.start(dt);
    double squares = 0, scale = 0, change = 0;
    for (int n = 1; n <= 250; ++n) {
        ASSERT_EQ(c.step(dt).rejected, 0);
        const double t = n * dt;
        double theory = H * s * (1 - std::cos(Omega * t)) / L;
        for (int m = 1; m < 60; ++m) {
            const double k = m * pi / L, w2 = g * k * std::tanh(k * H);
            const double eta = 2 * std::tanh(k * H) / (k * L) * s * Omega * Omega *
                               (std::cos(Omega * t) - std::cos(std::sqrt(w2) * t)) / (w2 - Omega * Omega);
            theory += (m % 2 ? -1 : 1) * eta;
        }
        squares += std::pow(levelAt(c, 1) - H - theory, 2);
        scale += theory * theory;
        change = std::max(change, std::abs(totalVolume<2>(c.state) / volume - 1));
    }
    std::cout << "rms difference " << std::sqrt(squares / scale) << " of the level's, volume changes by " << change
              << "\n";
    EXPECT_LT(std::sqrt(squares / scale), 0.05);
    EXPECT_LT(change, 1e-4);
    EXPECT_NEAR(c.state.nodes.x[nodeOf(c.state.nodes, c.state.nodes.id[nearestNode(c.state.nodes.X, {0, 0.6})])][0],
                0.01, 1e-9);
}

// A piston that pushes a third of the water together and comes back: the corner at its foot takes and gives nodes.
TEST(Piston, longStrokeKeepsTheWater) {
    TestCase c = pistonTank("displacement expression (\"0.15*(1 - cos(pi*t))\" \"0\" \"0\");");
    c.controls.continuity.volumeCorrectionTime = 0;
    const double volume = totalVolume<2>(c.state);
    c.start(5e-3);
    int foot = c.state.mesh.patches[0].faces[0][1];
    const Id id = c.state.nodes.id[foot];
    ASSERT_LT(c.state.nodes.x[foot].norm(), 1e-9);
    for (int n = 0; n < 400; ++n) {
        c.step(5e-3);
        foot = nodeOf(c.state.nodes, id);
        const double x = c.state.nodes.x[foot][0];
        for (int i = 0; i < c.state.nodes.size(); ++i)
            if (c.topology().wet(i)) {
                ASSERT_GT(c.state.nodes.x[i][0], x - 1e-9) << "behind the piston";
            }
    }
    std::cout << "volume changes by " << totalVolume<2>(c.state) / volume - 1 << "\n";
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 0.01 * volume);
    EXPECT_NEAR(totalVolume<2>(c.state), volume + c.ledgerSum(), 1e-9 * volume);
    EXPECT_NEAR(c.state.nodes.x[foot][0], 0, 1e-9);
}

TestCase gateTank(const std::string& motion) {
    return makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.5, 0.5) +
                        " } ); walls ( gate { moving true; points ((0.5 0) (0.5 1)); } tank { points ((0 1) (0 0) (2 "
                        "0) (2 1)); } );",
                    water, "tank { type slip; } gate { type slip; motion { " + motion + " } }");
}

double front(const TestCase& c) {
    const auto topology = c.topology();
    double x = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i)) x = std::max(x, c.state.nodes.x[i][0]);
    return x;
}

// A gate that waits holds the water; lifted, it lets it out below; the fastest as if there were none.
TEST(Gate, liftsFromTheFloor) {
    TestCase resting = gateTank("velocity (0 0 0);");
    resting.tolerance(1e-10);
    resting.start(5e-3);
    for (int n = 0; n < 20; ++n) resting.step(5e-3);
    EXPECT_LT(pressureError(resting, {0, 0}, 0.5), 1e-6);
    EXPECT_NEAR(front(resting), 0.5, 1e-9);

    TestCase sudden =
        makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.5, 0.5) +
                     " } ); walls ( tank { points ((0 1) (0 0) (2 0) (2 1)); } );",
                 water, "tank { type slip; }");
    sudden.start(2e-3);
    for (int n = 0; n < 60; ++n) sudden.step(4e-3);
    std::vector<double> fronts;
    for (const char* speed : {"1", "4", "20"}) {
        TestCase c = gateTank("velocity (0 " + std::string(speed) + " 0);");
        const double volume = totalVolume<2>(c.state);
        c.start(2e-3);
        for (int n = 0; n < 60; ++n) c.step(4e-3);
        fronts.push_back(front(c));
        std::cout << speed << " m/s: front at " << fronts.back() << " m, volume changes by "
                  << totalVolume<2>(c.state) / volume - 1 << "\n";
        EXPECT_NEAR(totalVolume<2>(c.state), volume, 0.02 * volume);
        const int foot = c.state.mesh.patches[0].faces[0][0];
        EXPECT_NEAR(c.state.nodes.x[foot][1], c.state.time.value * std::stod(speed), 1e-6);
    }
    std::cout << "no gate: " << front(sudden) << " m\n";
    for (const double x : fronts) EXPECT_NEAR(x, front(sudden), 0.1);
    EXPECT_NEAR(fronts[2], front(sudden), 0.03);
}

TEST(MovingWalls, restartIsBitwise) {
    const TemporaryFolder folder;
    TestCase c = pistonTank("displacement { type sine; frequency 1.3; scale (0.08 0 0); }");
    c.start(4e-3);
    for (int n = 0; n < 30; ++n) c.step(4e-3);
    writeState(folder.path() / "0.12", c.state);
    TestCase again = c;
    again.state = readState<2>(folder.path() / "0.12");
    for (int n = 0; n < 60; ++n) {
        c.step(4e-3);
        again.step(4e-3);
    }
    expectIdentical(c.state, again.state);
    EXPECT_EQ(c.state.nodes.wall, again.state.nodes.wall);
}

// A solid whose clamped edge glides goes along without stress; one that is lifted with acceleration hangs on it.
TEST(MovingClamp, carriesTheSolid) {
    TestCase c = makeCase("meshSize 0.1; bodies ( block { type solid; material rubber; velocity (1 2); " +
                              rectangle(0, 0, 0.5, 0.5) + " patches { base { edges ((0 1)); } } } );",
                          rubber, "base { type clamped; motion { velocity (1 2 0); } }", {0, 0});
    c.tolerance(1e-10);
    c.start(1e-2);
    for (int n = 0; n < 50; ++n) c.step(1e-2);
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        EXPECT_LT((c.state.nodes.x[i] - c.state.nodes.X[i] - Vec<2>(0.5, 1)).norm(), 1e-9);
        EXPECT_LT(c.state.nodes.sigma[i].norm(), 1e-4);
    }
}

// A motion: a turn about a point that moves itself.
TEST(WallMotion, turnsAndTranslates) {
    const WallMotion motion(
        Dictionary::parse("displacement polynomial (((2 0 0) (1 0 0))); omega 0.5; origin (1 0 0);"));
    const auto step = motion.step<2>(1, 3);  // the centre from (3 0) to (7 0), turned by 1
    const Vec<2> after = step.carried({3, 2});
    EXPECT_NEAR(after[0], 7 - 2 * std::sin(1.0), 1e-12);
    EXPECT_NEAR(after[1], 2 * std::cos(1.0), 1e-12);
    EXPECT_LT((step.velocityAt({7, 2}) - Vec<2>(2 - 0.5 * 2, 0)).norm(), 1e-9);
    const WallMotion byAngle(Dictionary::parse("angle polynomial ((0.5 1)); origin (1 0 0); axis (0 0 3);"));
    EXPECT_LT((byAngle.step<2>(0, 2).carried({2, 0}) - Vec<2>(1 + std::cos(1.0), std::sin(1.0))).norm(), 1e-12);
}

TEST(WallMotion, mistakes) {
    const auto message = [](const std::string& conditions, const std::string& moving = "") -> std::string {
        try {
            const TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " +
                                            rectangle(0, 0, 1, 0.5) + " } ); walls ( left { " + moving +
                                            " points ((0 1) (0 0)); } rest { points ((0 0) (1 0) (1 1)); } );",
                                        water, conditions);
            checkConditions<2>(Dictionary::parse(conditions, "boundaryConditions"), c.problem.conditions, c.state);
        } catch (const UserError& error) {
            return error.what();
        }
        return "";
    };
    const auto left = [&](const std::string& motion) {
        return message("left { type slip; motion { " + motion + " } } rest { type slip; }");
    };
    EXPECT_NE(left("velocity (1 0 0);").find("moving true"), std::string::npos);
    EXPECT_EQ(message("left { type slip; motion { velocity (1 0 0); } } rest { type slip; }", "moving true;"), "");
    EXPECT_EQ(
        message("left { type slip; motion { velocity (1 0 0); } } rest { type slip; motion { velocity (1 0 0); } }"),
        "");
    EXPECT_NE(left("velocity (1 0 0); displacement (1 0 0);").find("not both"), std::string::npos);
    EXPECT_NE(left("omega 1;").find("origin"), std::string::npos);
    EXPECT_NE(left("").find("one of"), std::string::npos);
    EXPECT_NE(
        message("left { type symmetry; motion { velocity (1 0 0); } } rest { type slip; }").find("cannot be moved"),
        std::string::npos);
}

}  // namespace
