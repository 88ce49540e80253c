// A column of mud that collapses on a bed: Newton's steps across the yield stress.

#include <gtest/gtest.h>

#include "solver/newtonDamping.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

// Stiff up to the stress 1, ten times softer above: from the soft side Newton's step lands on the soft side opposite,
// and back.
double stress(double x) { return std::abs(x) < 1 ? x : std::copysign(0.9 + 0.1 * std::abs(x), x); }
double slope(double x) { return std::abs(x) < 1 ? 1 : 0.1; }

double errorAfter(int iterations, bool damped) {
    NewtonDamping<2> damping;
    double x = 11;
    for (int k = 0; k < iterations; ++k) {
        const double step = (0.5 - stress(x)) / slope(x);
        x += (damped ? damping.next({Vec<2>(step, 0)}) : 1) * step;
    }
    return std::abs(stress(x) - 0.5);
}

TEST(NewtonDamping, endsTheCycleAcrossABend) {
    EXPECT_GT(errorAfter(40, false), 0.1);
    EXPECT_LT(errorAfter(40, true), 1e-6);
}

TEST(NewtonDamping, takesWholeStepsOfOneDirection) {
    NewtonDamping<2> damping;
    for (const double step : {1.0, 0.5, 0.1, 0.2, 0.0}) EXPECT_EQ(damping.next({Vec<2>(step, step)}), 1);
    EXPECT_EQ(damping.next({Vec<2>(1, 0)}), 1);
    EXPECT_EQ(damping.next({Vec<2>(-1, 0)}), 0.5);
    EXPECT_EQ(damping.next({Vec<2>(-0.5, 0)}), 1);
}

/// Where a drop is after 0.2 s that lay at (1.5, 0) on the bed and went at 0.5 m/s.
double placeOfDrop(const std::string& wall) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.3) +
                              " } ); walls ( tank { points ((0 1) (0 0) (3 0)); } );",
                          water, "tank { type " + wall + "; }");
    Nodes<2>& nodes = c.state.nodes;
    const Nodes<2> old = nodes;
    nodes.append(old, nearestNode(old.x, {0.5, 0}));
    const int id = nodes.id.back() = c.state.nextId++;
    nodes.x.back() = {1.5, 0};
    nodes.v.back() = {0.5, 0};
    nodes.dropVolume.back() = 1e-4;
    c.start(1e-3);
    while (c.state.time.value < 0.2 - 1e-9) c.step(0.01);
    for (int i = 0; i < nodes.size(); ++i)
        if (nodes.id[i] == id) return nodes.x[i][0];
    return -1;
}

TEST(Drop, sticksToANoSlipWall) {
    EXPECT_NEAR(placeOfDrop("slip"), 1.6, 1e-9);
    EXPECT_EQ(placeOfDrop("noSlip"), 1.5);
}

// 20 triangles high, m = 100 s: a plug of 5000 Pa s beside mud of 10 Pa s.
TEST(MudColumn, hardlyAnyStepIsRejected) {
    TestCase c =
        makeCase("meshSize 0.015; bodies ( mud { type fluid; material mud; " + rectangle(0, 0, 0.2, 0.3) +
                     " } ); walls ( back { points ((0 0.5) (0 0)); } bed { points ((0 0) (2 0)); } );",
                 "mud { type bingham; rho 1000; mu 10; tau0 50; m 100; }", "back { type slip; } bed { type noSlip; }");
    c.controls.integration.integration = "elemental";
    c.start(1e-3);
    int steps = 0, rejected = 0;
    for (; c.state.time.value < 0.3; ++steps)
        rejected += c.step(std::min(5e-3, 0.3 / courantRate<2>(c.state).largest)).rejected;
    std::cout << steps << " steps, " << rejected << " rejected\n";
    EXPECT_LT(steps, 130);
    EXPECT_LE(rejected, 8);
}

}  // namespace
