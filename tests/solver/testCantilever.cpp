// Solids alone: the cantilever under a sudden end load (L 25, D 4, E 1e4, nu 1/4, rho 1, end shear 40).

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

double peak(int nx, int ny, double dt, double endTime, const std::string& update, double damping, double& timeOfPeak) {
    TestCase c = makeCase("meshSize 2; bodies ( beam { type solid; material steel; " + rectangle(0, 0, 25, 4) +
                              " pattern checkerboard; cells (" + std::to_string(nx) + " " + std::to_string(ny) +
                              "); patches { base { edges ((3 0)); } end { edges ((1 2)); } } } );",
                          "steel { type hypoelastic; rho 1; E 1e4; nu 0.25; }",
                          "base { type clamped; } end { type traction; traction (0 10 0); }", {0, 0});
    c.controls.solid.stressUpdate = update;
    c.controls.solid.damping = damping;
    c.tolerance(1e-6);
    c.start(dt);
    const int corner = nearestNode(c.state.nodes.X, {25, 4});
    double highest = 0;
    while (c.state.time.value < endTime - 0.5 * dt) {
        const auto report = c.step(dt);
        EXPECT_EQ(report.rejected, 0);
        const double u = c.state.nodes.x[corner][1] - c.state.nodes.X[corner][1];
        if (u > highest) {
            highest = u;
            timeOfPeak = c.state.time.value;
        }
    }
    return highest;
}

// Trial computation with the printed update: 8.841 (h = 2) and 7.520 (h = 1); the limit for h -> 0 is 6.9.
TEST(Cantilever, peakOfThePaperUpdate) {
    double t = 0;
    const double coarse = peak(12, 2, 0.01, 5.6, "paper", 0, t);
    std::cout << "h 2: peak " << coarse << " at " << t << " s\n";
    EXPECT_NEAR(coarse, 8.841, 0.005 * 8.841);
    const double fine = peak(25, 4, 0.01, 5, "paper", 0, t);
    std::cout << "h 1: peak " << fine << " at " << t << " s\n";
    EXPECT_NEAR(fine, 7.520, 0.005 * 7.520);
}

// The default update with its damper: the same within the step's error, and independent of the step.
TEST(Cantilever, peakOfTheRotatedMidpoint) {
    double t = 0;
    const double a = peak(12, 2, 0.01, 5.6, "rotatedMidpoint", 0.1, t);
    const double b = peak(12, 2, 0.04, 5.6, "rotatedMidpoint", 0.1, t);
    std::cout << "h 2: peak " << a << ", dt 0.04 " << b << "\n";
    EXPECT_NEAR(a, 8.85, 0.005 * 8.85);
    EXPECT_NEAR(b, a, 2e-3 * a);
}

}  // namespace
