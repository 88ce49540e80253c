// Solids that strike each other and walls: impact of bars, what impacts keep, many of them.

#include <gtest/gtest.h>

#include <cstdlib>

#include "conditions/rigidBodies.hpp"
#include "support/solids.hpp"
#include "walls/solidContact.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

struct Impact {
    double contact = 0;   // time together [s]
    double momentum = 0;  // afterwards, in parts of that of one bar before
    double speed = 0;     // of the right bar afterwards, in parts of that before
    double energy = 0;    // kinetic and elastic afterwards, in parts of that before
};

/// Two bars of 1 m meet with 0.1 m/s each, in plane strain between slip sides, nu 0: together for 2 L/c.
Impact bars(int cells, double courant, double damping = 0.1) {
    const double speed = 0.1, sound = 100, h = 1.0 / cells, dt = courant * h / sound;
    const std::string law = " { type hypoelastic; rho 1000; E 1e7; nu 0; } ";
    const std::string mesh = "pattern checkerboard; cells (" + std::to_string(cells) + " 1);";
    TestCase c = makeCase("meshSize " + std::to_string(h) + "; bodies ( left { type solid; material a; " + mesh +
                              " velocity (0.1 0); " + rectangle(-1, 0, 0, h) +
                              " patches { sides { edges ((0 1) (2 3)); } } } right { type solid; material b; " + mesh +
                              " velocity (-0.1 0); " + rectangle(0.1, 0, 1.1, h) +
                              " patches { sides { edges ((0 1) (2 3)); } } } );",
                          "a" + law + "b" + law, "sides { type symmetry; }", {0, 0});
    const double gap = 4e-3 * h;
    displace(c, "b", {-0.1 + gap, 0});
    c.problem.contact = {true, 0};
    c.controls.solid.damping = damping;
    c.tolerance(1e-9);
    const int i = nearestNode(c.state.nodes.X, {0, 0}), j = nearestNode(c.state.nodes.X, {gap, 0});
    const double before = solidEnergy(c);
    Impact impact;
    double first = 0, last = 0;
    for (double t = 0; t < 0.04; t += dt) {
        const auto report = c.step(dt);
        if (report.rejected > 0) ADD_FAILURE() << t << ": " << report.reasons.front();
        const double between = c.state.nodes.x[j][0] - c.state.nodes.x[i][0];
        EXPECT_GT(between, 0);
        if (between < 1.005e-3 * h) {  // solids keep 1e-3 h
            if (first == 0) first = c.state.time.value;
            last = c.state.time.value;
        }
    }
    const Vec<2> left = meanOf(c, c.state.nodes.v, "a"), right = meanOf(c, c.state.nodes.v, "b");
    impact = {last - first, (left[0] + right[0]) / speed, right[0] / speed, solidEnergy(c) / before};
    std::cout << cells << " cells, c dt/h " << courant << ", damping " << damping << ": contact for " << impact.contact
              << " s (0.02), momentum " << impact.momentum << ", speed " << impact.speed << ", energy " << impact.energy
              << "\n";
    return impact;
}

// What an impact takes is the energy of the surfaces' lumped masses, h/(2 L) of it, and the zig-zag damper its share of
// the wave's front: both fall with h, below 1 % together at 200 cells.
TEST(Impacts, barsThatMeetEndToEndExchangeTheirVelocities) {
    const Impact coarse = bars(25, 0.5), fine = bars(50, 0.5), finer = bars(100, 1), finest = bars(200, 1),
                 free = bars(100, 0.5, 0);
    for (const Impact& impact : {coarse, fine, finer, finest, free}) {
        EXPECT_NEAR(impact.contact, 0.02, 0.02 * 0.02);
        EXPECT_NEAR(impact.momentum, 0, 1e-10);
        EXPECT_LE(impact.energy, 1);
    }
    for (const auto& [before, after] : {std::pair(coarse, fine), {fine, finer}, {finer, finest}})
        EXPECT_LT(1 - after.energy, 0.6 * (1 - before.energy));
    EXPECT_GT(fine.speed, 0.96);
    EXPECT_GT(finest.energy, 0.99);
    EXPECT_GT(free.energy, 0.99);
}

/// Six blocks in a closed box, 0.2 m wide, h 0.1 m.
TestCase sixBlocks() {
    std::string bodies;
    for (int k = 0; k < 6; ++k) {
        const int row = k / 3;
        const double x = 0.15 + 0.3 * (k % 3), y = 0.2 + 0.35 * row;
        bodies += "b" + std::to_string(k) + " { type solid; material stone; pattern checkerboard; cells (2 2); " +
                  rectangle(x, y, x + 0.2, y + 0.2) + " }";
    }
    TestCase c = makeCase(
        "meshSize 0.1; bodies (" + bodies + "); walls ( box { points ((0 0) (1.2 0) (1.2 0.9) (0 0.9) (0 0)); } );",
        "stone { type rigid; rho 2000; }", "box { type slip; }", {0, 0});
    c.problem.contact = {true, 0.3};
    return c;
}

/// Bodies that have become slow get another velocity, whatever touches them.
void kick(TestCase& c, std::mt19937& random) {
    std::uniform_real_distribution<double> value(-3, 3);
    for (const auto& body : rigidBodies<2>(c.problem, c.state.mesh, c.state.nodes)) {
        const Twist<2> twist(value(random), value(random), 3 * value(random));
        if (body.twist.norm() > 1) continue;
        for (std::size_t k = 0; k < body.nodes.size(); ++k)
            c.state.nodes.v[body.nodes[k]] = leverRows<2>(body.pose.lever(body.arm[k])) * twist;
    }
}

/// Nodes that would enter a wall or a solid within the step.
long struck(const TestCase& c, double dt) {
    const auto pairs = contactPairs<2>(c.problem, c.state.mesh, c.topology(), c.state.nodes, dt);
    return std::count_if(pairs.begin(), pairs.end(),
                         [&](const auto& pair) { return pair.gap + dt * pair.relative(c.state.nodes.v)[0] < 0; });
}

TEST(Impacts, manyOfThemLetNothingIn) {
    const long wanted = std::getenv("PFEM_LONG_TESTS") ? 100000 : 20000;
    const double dt = 5e-3;
    TestCase c = sixBlocks();
    std::mt19937 random(3);
    long impacts = 0;
    double inWalls = 0, inSolids = 0;
    int steps = 0, rejected = 0;
    for (; impacts < wanted && steps < wanted; ++steps) {
        kick(c, random);
        impacts += struck(c, dt);
        rejected += c.step(dt).rejected;
        inWalls = std::max(inWalls, depthInWalls(c));
        inSolids = std::max(inSolids, depthInSolids(c));
    }
    std::cout << impacts << " impacts in " << steps << " steps, " << rejected << " rejected, deepest in walls "
              << inWalls << " h, in solids " << inSolids << " h\n";
    EXPECT_GE(impacts, wanted);
    EXPECT_LT(rejected, 0.002 * steps);
    EXPECT_LT(inWalls, 1e-3);
    EXPECT_LT(inSolids, 1e-3);
}

}  // namespace
