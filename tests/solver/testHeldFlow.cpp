// A flow that a body force holds between periodic sides.

#include <gtest/gtest.h>

#include "functions/balance.hpp"
#include "functions/controlVolume.hpp"
#include "functions/periodicFlow.hpp"
#include "functions/storedEnergy.hpp"
#include "periodicCases.hpp"
#include "state/volume.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

void hold(TestCase& c, const std::string& text) {
    c.problem.flow = heldFlowOf<2>(Dictionary::parse(text, "periodic"), c.problem.period);
}

double meanSpeed(const State<2>& state) {
    const auto flow = fluidFlow<2>(state);
    return flow.integral[0] / flow.volume;
}

/// A channel of height 1 with a mean speed of 1, full of syrup, in which everything moves alike at first.
TestCase channelAtOnce(double h, const std::string& flow) {
    TestCase c = periodic(
        1.5,
        "meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1.5, 1) +
            " velocity (1 0); } ); walls ( bottom { points ((-2 0) (4 0)); } top { points ((4 1) (-2 "
            "1)); } );",
        "water { type newtonian; rho 2; mu 0.2; kappa 1e6; }", "bottom { type noSlip; } top { type noSlip; }", {0, 0});
    hold(c, flow);
    c.start(0.01);
    return c;
}

// Plane Poiseuille flow: u = 6 y (1 - y), and the force 12 nu U/H^2, that is a pressure drop of 12 mu U/H^2 L. The
// force is that of the steps, and that which the momentum of a state asks for.
TEST(HeldFlow, poiseuilleFlow) {
    TestCase c = channelAtOnce(0.05, "meanVelocity (1 0 0);");
    double largestError = 0;
    for (int n = 0; n < 100; ++n) {
        c.step(0.02);
        largestError = std::max(largestError, std::abs(meanSpeed(c.state) - 1));
    }
    double ofSteps = 0, ofStates = 0, squares = 0;
    int count = 0, rounds = 0;
    for (int n = 0; n < 50; ++n) {
        const auto report = c.step(0.02);
        rounds = std::max(rounds, report.step.iterations);
        ofSteps += report.step.drive[0] / 50;
        ofStates += driveOf<2>(c.problem, c.controls, c.state)[0] / 50;
        for (int i = 0; i < c.state.nodes.size(); ++i, ++count) {
            const double y = c.state.nodes.x[i][1];
            squares += (c.state.nodes.v[i] - Vec<2>(6 * y * (1 - y), 0)).squaredNorm();
        }
        largestError = std::max(largestError, std::abs(meanSpeed(c.state) - 1));
    }
    std::cout << "force " << ofSteps << " of steps, " << ofStates << " of states; profile "
              << std::sqrt(squares / count) / 1.5 << ", mean speed off by " << largestError << ", rounds " << rounds
              << "\n";
    EXPECT_NEAR(ofSteps, 1.2, 0.012);
    EXPECT_NEAR(ofStates, 1.2, 0.012);
    EXPECT_LT(std::sqrt(squares / count), 0.01 * 1.5);
    EXPECT_LT(largestError, 3e-4);
}

TEST(HeldFlow, poiseuilleFlowOfSecondOrder) {
    double error[2];
    for (const int n : {0, 1}) {
        TestCase c = channelAtOnce(n == 0 ? 0.14 : 0.07, "flowRate (1 0 0);");
        run(c, 2, 0.04);
        double drive = 0;
        for (int k = 0; k < 50; ++k) drive += c.step(0.02).step.drive[0] / 50;
        error[n] = std::abs(drive - 1.2);
        std::cout << "force " << drive << "\n";
    }
    EXPECT_LT(error[1], 0.5 * error[0]);
}

// A layer with a free surface on a slippery floor that speeds up by 5 m/s2, and goes on: nothing else acts along it.
TEST(HeldFlow, forceIsTheAcceleration) {
    TestCase c = periodic(1.5,
                          "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1.5, 0.5) +
                              " velocity (2 0); } ); walls ( floor { points ((-1 0) (3 0)); } );",
                          water, "floor { type slip; }", {0, -9.81});
    hold(c, "meanVelocity { type table; values ((0 (2 0 0)) (0.1 (2.5 0 0))); }");
    c.tolerance(1e-8);
    c.start(0.01);
    const double volume = totalVolume<2>(c.state);
    for (int n = 0; n < 20; ++n) {
        const auto report = c.step(0.01);
        EXPECT_NEAR(report.step.drive[0], n < 10 ? 5 : 0, 1e-5) << n;
        EXPECT_EQ(report.step.drive[1], 0);
        EXPECT_NEAR(meanSpeed(c.state), std::min(2.5, 2 + 0.05 * (n + 1)), 1e-7);
        const double power = n < 10 ? 1000 * volume * 5 * meanSpeed(c.state) : 0;
        const double push = n < 10 ? 1000 * 0.5 * 1 * 5 : 0;  // on a metre of the layer
        EXPECT_NEAR(momentumRates<2>(c.problem, c.controls, c.state, {{0.25, 0}, {1, 0}, 1, 0.2}).gravity, push, 50);
        EXPECT_NEAR(energyPowers<2>(c.problem, c.controls, c.state).drive, power, 1e-4 * 1000 * volume * 5 * 2) << n;
    }
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-7);
}

// The same in space.
TEST(HeldFlow, forceIsTheAccelerationInSpace) {
    TestCase3 c = trough({2, 0, 0});
    const auto text =
        Dictionary::parse("meanVelocity { type table; values ((0 (2 0 0)) (0.1 (2.5 0 0))); }", "periodic");
    c.problem.flow = heldFlowOf<3>(text, c.problem.period);
    c.tolerance(1e-8);
    c.start(0.01);
    for (int n = 0; n < 10; ++n) {
        const auto report = c.step(0.02);
        EXPECT_NEAR(report.step.drive[0], n < 5 ? 5 : 0, 1e-5) << n;
        const auto flow = fluidFlow<3>(c.state);
        EXPECT_NEAR(flow.integral[0] / flow.volume, std::min(2.5, 2.1 + 0.1 * n), 1e-7);
        const double power = n < 5 ? 1000 * flow.volume * 5 * flow.integral[0] / flow.volume : 0;
        EXPECT_NEAR(energyPowers<3>(c.problem, c.controls, c.state).drive, power, 1e-3 * 1000 * flow.volume * 5 * 2);
    }
}

// A block on which the channel's water parts: pressure answers to the force, too.
TEST(HeldFlow, roundABlock) {
    TestCase c = periodic(
        3,
        "meshSize 0.06; bodies ( water { type fluid; material water; " + rectangle(0, 0, 3, 1) +
            " holes (block); } block { type solid; material rubber; " + rectangle(1.3, 0.3, 1.7, 0.7) +
            " patches { held { edges ((0 1) (1 2) (2 3) (3 0)); } } } ); walls ( bottom { points ((-2 0) (5 0)); } "
            "top { points ((5 1) (-2 1)); } );",
        "water { type newtonian; rho 1; mu 0.1; kappa 1e6; } " + rubber,
        "bottom { type slip; } top { type slip; } held { type clamped; }", {0, 0});
    hold(c, "flowRate { type table; values ((0 (0 0 0)) (0.5 (1 0 0))); }");
    c.start(0.01);
    int rounds = 0;
    double largestError = 0;
    Vec<2> onBlock = Vec<2>::Zero(), drive = Vec<2>::Zero();
    for (int n = 0; n < 100; ++n) {
        const auto report = c.step(0.02);
        rounds = std::max(rounds, report.step.iterations);
        const double rate = fluidFlow<2>(c.state).integral[0] / 3;
        largestError = std::max(largestError, std::abs(rate - std::min(1.0, 2 * c.state.time.value)));
        if (n < 50) continue;
        const auto forces = supportForces<2>(c.problem, c.controls, c.state);
        const auto topology = c.topology();
        for (int i = 0; i < c.state.nodes.size(); ++i)
            if (topology.onSolid[i]) onBlock += forces[i] / 50;
        drive += report.step.drive.head<2>() / 50;
    }
    std::cout << "rounds " << rounds << ", flow off by " << largestError << ", force on the block " << onBlock[0]
              << " of " << -drive[0] * totalVolume<2>(c.state) << "\n";
    EXPECT_LT(largestError, 5e-3);
    EXPECT_LT(rounds, 15);
    EXPECT_NEAR(onBlock[0], -drive[0] * totalVolume<2>(c.state), 0.03 * drive[0] * totalVolume<2>(c.state));
}

TEST(HeldFlow, refused) {
    const TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " +
                                    rectangle(0, 0, 1.5, 0.5) + " } ); walls ( floor { points ((-1 0) (3 0)); } );",
                                water, "floor { type slip; }");
    EXPECT_EQ(refusalOf(c, "x (0 1.5); flowRate (1 0 0);"), "");
    EXPECT_NE(refusalOf(c, "x (0 1.5); flowRate (1 0 0); meanVelocity (1 0 0);").find("not both"), std::string::npos);
    EXPECT_NE(refusalOf(c, "x (0 1.5); meanVelocity (1 0.1 0);").find("there are none in y"), std::string::npos);
    EXPECT_NE(refusalOf(c, "flowRate (1 0 0);").find("there are none in x"), std::string::npos);
}

}  // namespace
