// Solids alone: the cantilever's first peak, of all integrations and stress updates.

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/cantilever.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

struct Peak {
    double value = 0, time = 0;
    int iterations = 0;  // in the mean over all steps, rounded up
};

Peak peak(const std::string& cells, double dt, double endTime, const std::string& integration,
          const std::string& update, double damping, const std::string& formulation = "velocity") {
    TestCase c = cantilever(cells, "checkerboard", integration, update, damping);
    c.controls.solid.formulation = formulation;
    c.start(dt);
    const int corner = nearestNode(c.state.nodes.X, {25, 4});
    Peak p;
    int steps = 0, iterations = 0;
    for (; c.state.time.value < endTime - 0.5 * dt; ++steps) {
        const auto report = c.step(dt);
        EXPECT_EQ(report.rejected, 0);
        iterations += report.step.iterations;
        const double u = c.state.nodes.x[corner][1] - c.state.nodes.X[corner][1];
        if (u > p.value) p = {u, c.state.time.value, 0};
    }
    p.iterations = (iterations + steps - 1) / steps;
    std::cout << integration << " " << formulation << " " << update << " " << cells << " dt " << dt << ": peak "
              << p.value << " at " << p.time << " s, iterations " << p.iterations << "\n";
    return p;
}

// Trial computations with the printed update, h = 2, 1, 0.5: nodal from above, elemental from below; the limit for
// h -> 0 is 6.88 (Belytschko and Bindeman).
TEST(Cantilever, nodalFromAboveElementalFromBelow) {
    const double limit = 6.88;
    const auto check = [&](const std::string& cells, double nodal, double elemental, double mixed, double endTime) {
        const double n = peak(cells, 0.01, endTime, "nodal", "paper", 0).value;
        const double v = peak(cells, 0.01, endTime, "elemental", "paper", 0).value;
        const double vp = peak(cells, 0.01, endTime, "elemental", "paper", 0, "velocityPressure").value;
        EXPECT_NEAR(n, nodal, 0.005 * nodal);
        EXPECT_NEAR(vp, mixed, 0.005 * mixed);
        EXPECT_NEAR(v, elemental, 0.005 * elemental);
        EXPECT_GT(n, limit);
        EXPECT_LT(v, limit);
        EXPECT_LT(vp, limit);
    };
    check("(13 2)", 8.841, 4.552, 5.166, 5.6);
    check("(25 4)", 7.520, 6.069, 6.354, 5);
    if (std::getenv("PFEM_LONG_TESTS")) check("(50 8)", 7.056, 6.650, 6.738, 5);
}

// The default update with its damper: the same within the step's error, and independent of the step.
TEST(Cantilever, peakOfTheRotatedMidpoint) {
    const double a = peak("(13 2)", 0.01, 5.6, "nodal", "rotatedMidpoint", 0.1).value;
    const double b = peak("(13 2)", 0.04, 5.6, "nodal", "rotatedMidpoint", 0.1).value;
    EXPECT_NEAR(a, 8.85, 0.005 * 8.85);
    EXPECT_NEAR(b, a, 2e-3 * a);
    const double v = peak("(13 2)", 0.04, 5.6, "elemental", "rotatedMidpoint", 0.1).value;
    EXPECT_NEAR(v, 4.56, 0.005 * 4.56);
}

// The hyperelastic law is another material only where strains are finite (here below 6 %).
TEST(Cantilever, peakOfTheNeoHookeanUpdate) {
    for (const char* integration : {"nodal", "elemental"}) {
        const Peak neo = peak("(13 2)", 0.02, 5.6, integration, "neoHookean", 0.1);
        const Peak hypo = peak("(13 2)", 0.02, 5.6, integration, "rotatedMidpoint", 0.1);
        EXPECT_NEAR(neo.value, hypo.value, 0.01 * hypo.value);
        EXPECT_NE(neo.value, hypo.value);
        EXPECT_LE(neo.iterations, 7);
    }
}

}  // namespace
