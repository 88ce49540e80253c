// Solids that strike each other and walls: impact of bars, what impacts keep, many of them.

#include <gtest/gtest.h>

#include "support/solids.hpp"

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
// the wave's front: both fall with h.
TEST(Impacts, barsThatMeetEndToEndExchangeTheirVelocities) {
    const Impact coarse = bars(25, 0.5), fine = bars(50, 0.5), free = bars(100, 0.5, 0);
    for (const Impact& impact : {coarse, fine, free}) {
        EXPECT_NEAR(impact.contact, 0.02, 0.02 * 0.02);
        EXPECT_NEAR(impact.momentum, 0, 1e-10);
        EXPECT_LE(impact.energy, 1);
    }
    EXPECT_LT(1 - fine.energy, 0.6 * (1 - coarse.energy));
    EXPECT_GT(fine.speed, 0.96);
    EXPECT_GT(free.energy, 0.99);
}

}  // namespace
