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

TEST(Cantilever, peakDeflection) {
    for (const auto& [nx, ny] : {std::pair(6, 1), std::pair(12, 2), std::pair(13, 2), std::pair(25, 4)}) {
        double t = 0;
        std::cout << nx << "x" << ny << " peak " << peak(nx, ny, 0.01, 6, "paper", 0, t);
        std::cout << " at " << t;
        std::cout << " midpoint " << peak(nx, ny, 0.01, 6, "rotatedMidpoint", 0.1, t) << " at " << t << "\n";
    }
}

}  // namespace
