// Inlets and outlets: what comes in is what is prescribed, what is there is what has come less what has gone, and the
// flow between is the known one.

#include <gtest/gtest.h>

#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "mesher/openings.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

// ---- plane Poiseuille flow: height 1, mean speed 1, Re = 10

constexpr double length = 2, mu = 0.1;
const std::string syrup = "water { type newtonian; rho 1; mu 0.1; kappa 1e6; }";

std::string channelMesh(double h, const std::string& more) {
    return "meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " +
           rectangle(0, 0, length, 1) + more +
           " } ); walls ( bottom { points ((0 0) (2 0)); } right { points ((2 0) (2 1)); } top { points ((2 1) (0 1)); "
           "} left { points ((0 1) (0 0)); } );";
}

TestCase channel(double h, const std::string& inlet, const std::string& outlet = "pressure 0;") {
    TestCase c = makeCase(channelMesh(h, "velocity expression (\"6*y*(1-y)\" \"0\");"), syrup,
                          "bottom { type noSlip; } top { type noSlip; } left { type inlet; " + inlet +
                              " } right { type outlet; " + outlet + " }",
                          {0, 0});
    c.start(0.01);
    return c;
}

/// Root mean square of u - 6 y (1 - y) between x = 0.5 and 1.5, and the slope of the pressure there.
struct Flow {
    double error, slope;
};
Flow flowOf(const TestCase& c) {
    double squares = 0, xx = 0, xp = 0, x1 = 0, p1 = 0;
    int count = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (x[0] < 0.5 || x[0] > 1.5) continue;
        squares += (c.state.nodes.v[i] - Vec<2>(6 * x[1] * (1 - x[1]), 0)).squaredNorm();
        ++count;
        xx += x[0] * x[0];
        xp += x[0] * c.state.nodes.p[i];
        x1 += x[0];
        p1 += c.state.nodes.p[i];
    }
    return {std::sqrt(squares / count), (count * xp - x1 * p1) / (count * xx - x1 * x1)};
}

void run(TestCase& c, double time, double dt) {
    const double end = c.state.time.value + time;
    while (c.state.time.value < end - 0.1 * dt) c.step(std::min(dt, end - c.state.time.value));
}

/// Volume of the fluid, drops included, less what came through openings: the first one but for errors of the method.
double kept(const TestCase& c) { return totalVolume<2>(c.state) - c.state.ledger.sum(CauseKind::passage); }

TEST(Openings, poiseuilleFlowPasses) {
    double before = 0;
    for (const double h : {0.2, 0.1}) {
        TestCase c = channel(h, "flowRate 1; profile parabolic;");
        const double first = kept(c);
        run(c, 4, 0.1 * h);
        EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 4, 1e-11);
        EXPECT_NEAR(c.state.ledger[VolumeCause::solver], 0, 0.04);  // it comes in where it should
        EXPECT_NEAR(kept(c), first, 2e-3 * first);
        EXPECT_NEAR(c.ledgerSum(), totalVolume<2>(c.state) - first, 1e-11);
        const Flow flow = flowOf(c);
        EXPECT_NEAR(flow.slope, -12 * mu, 0.6 * h);
        EXPECT_LT(flow.error, 3.5 * h * h);
        if (before > 0) {
            EXPECT_LT(flow.error, 0.5 * before);
        }
        before = flow.error;
    }
}

// What nodes lack belongs to the account: cells + drops + lost = first + compression + passage.
TEST(Openings, nothingIsLost) {
    TestCase c = channel(0.2, "velocity { type sine; frequency 1; scale 0.5; level 1; } profile parabolic;");
    const double first = totalVolume<2>(c.state);
    run(c, 1.3, 0.02);
    double lost = 0;
    for (const double one : c.state.nodes.lostVolume) lost += one;
    const auto& ledger = c.state.ledger;
    EXPECT_NEAR(ledger[VolumeCause::inflow], 1.3 + 0.5 * (1 - std::cos(2 * M_PI * 1.3)) / (2 * M_PI), 1e-11);
    EXPECT_NEAR(totalVolume<2>(c.state) + lost,
                first + ledger[VolumeCause::compression] + ledger.sum(CauseKind::passage), 1e-11);
}

// A stream that begins as it comes in, wholly between slippery walls: uniform from the first step on, also where it
// leaves. With a row of water at rest at the outlet it began 10 % off.
TEST(Openings, uniformStreamFromTheStart) {
    const std::string mesh =
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.4) +
        " velocity (2 0); } ); walls ( bottom { points ((0 0) (1 0)); } right { points ((1 0) (1 0.4)); } top { points "
        "((1 0.4) (0 0.4)); } left { points ((0 0.4) (0 0)); } );";
    const std::string conditions =
        "bottom { type slip; } top { type slip; } left { type inlet; velocity 2; } right { type outlet; pressure 0; }";
    auto description = readMeshDict(Dictionary::parse(mesh, "meshDict"), {"water"});
    markOpenings(Dictionary::parse(conditions, "boundaryConditions"), description);
    TestCase c = makeCase(mesh, water, conditions, {0, 0});
    c.state = buildMesh(description).state;
    c.start(0.01);
    for (int n = 0; n <= 20; ++n) {
        const auto topology = c.topology();
        for (int i = 0; i < c.state.nodes.size(); ++i) {
            if (!topology.wet(i)) continue;
            EXPECT_LT((c.state.nodes.v[i] - Vec<2>(2, 0)).norm(), 1e-12) << n;
            EXPECT_LT(std::abs(c.state.nodes.p[i]), 1e-9) << n;  // rho v^2 is 4000
        }
        c.step(0.01);
    }
}

// ---- a box in still water that gets faster by 2 m/s2, seen from within: at rest in a stream that gets faster

/// `more`: further walls, and their conditions.
TestCase movingBox(const std::string& outlet, const Vec<2>& gravity, const std::string& walls,
                   const std::string& conditions) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.4) +
                              " } ); walls ( bed { points ((0 0) (1 0)); } right { points ((1 0) (1 0.4)); } left { "
                              "points ((0 0.4) (0 0)); } " +
                              walls + " );",
                          water,
                          "bed { type slip; } left { type inlet; velocity polynomial ((2 1)); } right { type outlet; " +
                              outlet + " }" + conditions,
                          gravity);
    c.problem.frameOverTime =
        readFunction1<Eigen::Vector3d>(Dictionary::parse("V polynomial (((-2 0 0) (1 1 1)));"), "V");
    c.tolerance(1e-10);
    c.start(0.01);
    return c;
}

/// Largest difference of the wet nodes' velocities from 2 t, and of their pressures from rho g (0.4 - y).
struct Deviation {
    double velocity = 0, pressure = 0;
};
Deviation deviation(const TestCase& c, double g) {
    Deviation most;
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        if (!topology.wet(i)) continue;
        most.velocity = std::max(most.velocity, (c.state.nodes.v[i] - Vec<2>(2 * c.state.time.value, 0)).norm());
        most.pressure =
            std::max(most.pressure, std::abs(c.state.nodes.p[i] - 1000 * g * (0.4 - c.state.nodes.x[i][1])));
    }
    return most;
}

// The water knows nothing of the box: under a lid the stream is uniform and without pressure.
TEST(Openings, aBoxThatGetsFasterInStillWater) {
    TestCase c = movingBox("pressure 0;", {0, 0}, "top { points ((1 0.4) (0 0.4)); }", " top { type slip; }");
    for (int n = 0; n < 20; ++n) {
        c.step(0.01);
        EXPECT_LT(deviation(c, 0).velocity, 1e-9) << n;
        EXPECT_LT(deviation(c, 0).pressure, 1e-3) << n;  // rho a L is 2000
    }
}

// The level outside is that of water at rest, not across the gravity that is felt in the box: this would draw the
// surface down by 0.2 m, and in a step the stream by 0.3 m/s.
TEST(Openings, theLevelOutsideStaysLevel) {
    TestCase c = movingBox("level 0.4;", {0, -9.81}, "", "");
    c.step(0.01);
    EXPECT_LT(deviation(c, 9.81).velocity, 2e-5);
    EXPECT_LT(deviation(c, 9.81).pressure, 1);
}

// With a kink of V within the first step: what the box gets faster by counts whole.
TEST(Openings, aBoxThatJerks) {
    TestCase c = movingBox("pressure 0;", {0, 0}, "top { points ((1 0.4) (0 0.4)); }", " top { type slip; }");
    const auto V = Dictionary::parse("V table ((0 (0 0 0)) (0.003 (0 0 0)) (0.007 (-0.5 0 0)) (1 (-0.5 0 0)));");
    c.problem.frameOverTime = readFunction1<Eigen::Vector3d>(V, "V");
    auto inlet = *c.problem.conditions.inlet[2];
    const auto speed = Dictionary::parse("v table ((0 0) (0.003 0) (0.007 0.5) (1 0.5));");
    inlet.rate = readFunction1<double>(speed, "v");
    c.problem.conditions.inlet[2] = std::make_shared<Inlet>(inlet);
    c.step(0.01);
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i) && c.state.nodes.x[i][0] > 0.2) {
            EXPECT_NEAR(c.state.nodes.v[i][0], 0.5, 1e-6);
        }
}

// Still water goes past with - V: an outlet for waves lets it out without a pressure of its own, and a sponge is at
// rest in the world, not in the box. Without these the stream would meet rho c V = 1000 Pa, and be slowed by 5 % in a
// step.
TEST(Openings, stillWaterPassesWavesOutletAndSponge) {
    const std::string mesh = "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.4) +
                             " velocity (1 0); } ); walls ( bed { points ((0 0) (1 0)); } right { points ((1 0) (1 "
                             "0.4)); } left { points ((0 0.4) (0 0)); } );";
    const std::string conditions =
        "bed { type slip; } left { type inlet; velocity 1; } right { type outlet; level 0.4; waveSpeed 1; } sponge { "
        "type "
        "damping; from (0 0 0); to (0.1 0 0); rate 5; exponent 0; }";
    auto description = readMeshDict(Dictionary::parse(mesh, "meshDict"), {"water"});
    markOpenings(Dictionary::parse(conditions, "boundaryConditions"), description);
    TestCase c = makeCase(mesh, water, conditions);
    c.state = buildMesh(description).state;
    c.problem.frameOverTime = readFunction1<Eigen::Vector3d>(Dictionary::parse("V (-1 0 0);"), "V");
    c.tolerance(1e-10);
    c.start(1e-2);
    c.step(1e-2);
    double slow = 0, pressed = 0;
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        if (!topology.wet(i)) continue;
        slow = std::max(slow, std::abs(c.state.nodes.v[i][0] - 1));
        pressed = std::max(pressed, std::abs(c.state.nodes.p[i] - 9810 * (0.4 - c.state.nodes.x[i][1])));
    }
    EXPECT_LT(slow, 1e-3);
    EXPECT_LT(pressed, 40);  // the surface of the first step: 1 % of rho g H
}

TEST(Openings, startAndStop) {
    TestCase c = channel(0.25, "flowRate 1; start 0.1; stop 0.3;");
    run(c, 0.5, 0.04);
    EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 0.2, 1e-12);
}

// ---- water under gravity: depth 0.4

TestCase basin(const std::string& right, const std::string& velocity = "(0 0)") {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.4) + " velocity " +
            velocity + "; } ); walls ( tank { points ((0 0.8) (0 0) (1 0)); } right { points ((1 0) (1 0.8)); } );",
        water, "tank { type slip; } right { " + right + " }");
    c.start(1e-3);
    return c;
}

TEST(Openings, stillWaterRestsAtItsOwnLevel) {
    TestCase c = basin("type outlet; level 0.4;");
    run(c, 0.2, 0.01);
    EXPECT_LT(largest(c.state.nodes.v), 1e-6);
    EXPECT_NEAR(c.state.ledger[VolumeCause::outflow], 0, 1e-8);
}

// A lower level outside draws water, a higher one brings it back; the tank keeps the account.
TEST(Openings, levelOutsideDrawsWater) {
    TestCase low = basin("type outlet; level 0.3;"), high = basin("type outlet; level 0.5;");
    for (TestCase* c : {&low, &high}) {
        const double first = kept(*c);
        run(*c, 0.2, 5e-3);
        EXPECT_NEAR(c->ledgerSum(), totalVolume<2>(c->state) - first, 1e-12);
        EXPECT_NEAR(kept(*c), first, 2e-3 * first);
    }
    EXPECT_LT(low.state.ledger[VolumeCause::outflow], -5e-3);
    EXPECT_GT(high.state.ledger[VolumeCause::outflow], 5e-3);
}

// A floor that is an outlet: water falls through it freely.
TEST(Openings, waterFallsThroughAnOutlet) {
    TestCase c = makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " +
                              rectangle(0.4, 0.1, 0.6, 0.3) + " } ); walls ( floor { points ((0 0) (1 0)); } );",
                          water, "floor { type outlet; }");
    c.start(1e-3);
    const double first = totalVolume<2>(c.state);
    run(c, 0.2, 5e-3);
    const double through = 0.2 * (0.5 * 9.81 * 0.2 * 0.2 - 0.1);
    EXPECT_NEAR(c.state.ledger[VolumeCause::outflow], -through, 0.01 * through);
    EXPECT_NEAR(kept(c), first, 0.01 * first);
    EXPECT_NEAR(c.ledgerSum(), totalVolume<2>(c.state) - first, 1e-13);
    run(c, 0.2, 5e-3);  // until the last of it is through
    EXPECT_EQ(totalVolume<2>(c.state), 0);
    EXPECT_NEAR(c.state.ledger[VolumeCause::outflow], -first, 0.02 * first);
    EXPECT_NEAR(c.ledgerSum(), -first, 1e-13);
}

// A sluice in a plane wall, named after it: its lip is the inlet's, and the stream keeps its depth.
TEST(Openings, aSluiceBelowAGate) {
    TestCase c = makeCase("meshSize 0.02; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.6, 0.1) +
                              " velocity (3 0); } ); walls ( gate { points ((0 0.3) (0 0.1)); } bed { points ((0 0) (2 "
                              "0)); } sluice { points ((0 0.1) (0 0)); } );",
                          water, "gate { type slip; } bed { type slip; } sluice { type inlet; velocity 3; }");
    c.start(1e-3);
    run(c, 0.3, 2e-3);
    EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 0.3 * 3 * 0.1, 1e-10);
    double top = 0, low = 1;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (!c.topology().freeSurface[i] || x[0] > 0.5) continue;
        top = std::max(top, x[1]);
        low = std::min(low, x[1]);
    }
    EXPECT_NEAR(top, 0.1, 0.005);
    EXPECT_NEAR(low, 0.1, 0.005);
}

// The same when water falls on the stream along the gate: the lip's node stays, whoever comes near, and the stream has
// its depth again when that water has gone.
TEST(Openings, aSluiceThatIsSplashed) {
    TestCase c =
        makeCase("meshSize 0.02; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.6, 0.1) +
                     " velocity (3 0); } splash { type fluid; material water; " + rectangle(0, 0.15, 0.1, 0.3) +
                     " velocity (-0.5 -1.5); } ); walls ( gate { points ((0 0.5) (0 0.1)); } bed { points ((0 "
                     "0) (2 0)); } sluice { points ((0 0.1) (0 0)); } );",
                 water, "gate { type slip; } bed { type slip; } sluice { type inlet; velocity 3; }");
    c.start(1e-3);
    run(c, 0.7, 2e-3);
    EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 0.7 * 3 * 0.1, 1e-10);
    double top = 0, low = 1;
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (!topology.wet(i) || !topology.freeSurface[i] || x[0] > 0.3) continue;
        top = std::max(top, x[1]);
        low = std::min(low, x[1]);
    }
    EXPECT_NEAR(top, 0.1, 0.01);
    EXPECT_NEAR(low, 0.1, 0.01);
}

// A basin that runs dry goes on being computed: its last triangles change by much of themselves.
TEST(Openings, aBasinRunsDry) {
    TestCase c =
        makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.4, 0.1) +
                     " } ); walls ( tank { points ((0 0.4) (0 0) (0.4 0)); } right { points ((0.4 0) (0.4 0.4)); } );",
                 water, "tank { type slip; } right { type outlet; }");
    c.start(1e-3);
    const double first = totalVolume<2>(c.state);
    for (int n = 0; n < 2000 && c.state.time.value < 3; ++n)
        c.step(std::min(0.01, 0.4 / std::max(40.0, courantRate<2>(c.state).largest)));
    EXPECT_LT(totalVolume<2>(c.state), 0.1 * first);  // a film is left
    EXPECT_NEAR(kept(c), first, 0.02 * first);
    EXPECT_NEAR(c.ledgerSum(), totalVolume<2>(c.state) - first, 1e-12);
}

// A nozzle in the air: dry at first, then a jet that falls as a parabola says. Returns how far above it the first water
// is.
double jetAboveItsParabola(double h) {
    TestCase c = makeCase(
        "meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.1) +
            " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } nozzle { points ((0.7 0.6) (0.7 "
            "0.7)); } );",
        water, "tank { type slip; } nozzle { type inlet; velocity 1; }");
    c.start(1e-3);
    const double first = totalVolume<2>(c.state);
    run(c, 0.2, 0.2 * h);
    EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 0.1 * 0.2, 1e-12);
    EXPECT_NEAR(c.ledgerSum(), totalVolume<2>(c.state) - first, 1e-12);
    EXPECT_NEAR(kept(c), first, 2e-4);
    double tip = 1, low = 1;  // of the jet
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (x[1] < 0.15 || !c.topology().ofFluid(i)) continue;
        tip = std::min(tip, x[0]);
        low = std::min(low, x[1]);
    }
    EXPECT_NEAR(tip, 0.5, h);
    return low - (0.6 - 0.5 * 9.81 * 0.2 * 0.2);
}

// The first row hangs on the nozzle until its triangles are stretched by 1.7 h and divided: it falls later by up to
// 0.7 h/U, g t times that higher. First order in h.
TEST(Openings, aJetFromADryNozzle) {
    const double coarse = jetAboveItsParabola(0.02), fine = jetAboveItsParabola(0.01);
    constexpr double perSize = 9.81 * 0.2 * 0.7;  // U = 1
    EXPECT_LT(std::abs(coarse), perSize * 0.02);
    EXPECT_LT(std::abs(fine), perSize * 0.01);
    EXPECT_LT(std::abs(fine), 0.6 * std::abs(coarse));
}

TEST(Openings, aRestartIsTheRunItself) {
    const TemporaryFolder folder;
    TestCase c = channel(0.25, "flowRate 1;");
    for (int n = 0; n < 10; ++n) c.step(0.03);
    writeState(folder.path() / "0.3", c.state);
    TestCase again = c;
    again.state = readState<2>(folder.path() / "0.3");
    for (int n = 0; n < 20; ++n) {
        c.step(0.03);
        again.step(0.03);
    }
    expectIdentical(c.state, again.state);
}

}  // namespace
