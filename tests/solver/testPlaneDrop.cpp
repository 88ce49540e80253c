// A drop of water in the plane that becomes an ellipse (testSpace.cpp: the ball).

#include <gtest/gtest.h>

#include "state/volume.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// The long axis of an ellipse in potential flow v = r(t) (x, -y), free of gravity, with axes a and 1/a. The pressure
/// is p0 (1 - x^2/a^2 - y^2 a^2), and Euler's equations r' + r^2 = 2 p0/(rho a^2), -r' + r^2 = 2 p0 a^2/rho give a' = a
/// r, r' = -r^2 (a^4 - 1)/(a^4 + 1). Runge-Kutta from a = 1, r = A.
double longAxis(double A, double time) {
    using Pair = Eigen::Vector2d;
    const auto slope = [](const Pair& s) {
        const double a4 = std::pow(s[0], 4);
        return Pair(s[0] * s[1], -s[1] * s[1] * (a4 - 1) / (a4 + 1));
    };
    const int steps = 2000;
    const double dt = time / steps;
    Pair s(1, A);
    for (int n = 0; n < steps; ++n) {
        const Pair k1 = slope(s), k2 = slope(s + 0.5 * dt * k1), k3 = slope(s + 0.5 * dt * k2), k4 = slope(s + dt * k3);
        s += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return s[0];
}

/// Axes of an ellipse with the drop's second moments, a_k^2/4 of the area.
Vec<2> axesOf(const State<2>& state) {
    Vec<2> squares = Vec<2>::Zero();
    for (const auto& cell : state.mesh.fluid.nodes) {
        Vec<2> sum = Vec<2>::Zero(), own = Vec<2>::Zero();
        for (const int i : cell) sum += state.nodes.x[i], own += state.nodes.x[i].cwiseAbs2();
        squares += simplexMeasure<2>(state.nodes.x, cell) / 12 * (sum.cwiseAbs2() + own);
    }
    return (4 * squares / totalVolume<2>(state)).cwiseSqrt();
}

class PlaneDrop : public testing::TestWithParam<double> {};

TEST_P(PlaneDrop, becomesAnEllipse) {
    const double A = GetParam(), dt = 1e-4;
    TestCase c = makeCase(
        "meshSize 0.05; bodies { drop { type fluid; material water; vertices ((-1 0) (1 0)); edges (arc 0 1 (0 -1) arc "
        "1 0 (0 1)); } }",
        "water { type newtonian; rho 1000; mu 0; kappa 2.1e12; }", "", {0, 0});
    for (int i = 0; i < c.state.nodes.size(); ++i)
        c.state.nodes.v[i] = A * Vec<2>(c.state.nodes.x[i][0], -c.state.nodes.x[i][1]);
    c.start(dt);
    const double volume = totalVolume<2>(c.state), radius = std::sqrt(volume / M_PI);
    double a = 1;
    while (a < 2) {
        ASSERT_EQ(c.step(dt).rejected, 0);
        a = longAxis(std::abs(A), c.state.time.value);
    }
    Vec<2> axes = axesOf(c.state) / radius;
    if (A < 0) std::swap(axes[0], axes[1]);
    std::cout << "A " << A << ", " << c.state.mesh.fluid.size() << " triangles: axes " << axes.transpose()
              << ", theory " << a << " " << 1 / a << ", volume " << totalVolume<2>(c.state) / volume - 1 << "\n";
    EXPECT_NEAR(axes[0], a, 5e-3 * a);
    EXPECT_NEAR(axes[1], 1 / a, 5e-3 / a);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 5e-4 * volume);
}

INSTANTIATE_TEST_SUITE_P(, PlaneDrop, testing::Values(-100.0, 50.0));

}  // namespace
