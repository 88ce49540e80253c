// Contact of solids with walls and with each other: closed forms.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

std::string point(double x, double y) { return "(" + std::to_string(x) + " " + std::to_string(y) + ") "; }

/// Vertices of a rectangle, turned by `angle` about the origin.
std::string turned(double angle, double x0, double y0, double x1, double y1) {
    std::string text = "vertices (";
    for (const Vec<2>& p : {Vec<2>(x0, y0), Vec<2>(x1, y0), Vec<2>(x1, y1), Vec<2>(x0, y1)}) {
        const Vec<2> q = Eigen::Rotation2Dd(angle) * p;
        text += point(q[0], q[1]);
    }
    return text + ");";
}

std::set<int> nodesOf(const TestCase& c, const std::string& material) {
    std::set<int> nodes;
    for (int e = 0; e < c.state.mesh.solid.size(); ++e)
        if (c.state.mesh.materials[c.state.mesh.solid.material[e]] == material)
            nodes.insert(c.state.mesh.solid.nodes[e].begin(), c.state.mesh.solid.nodes[e].end());
    return nodes;
}

/// Mean of what the nodes of a material have.
Vec<2> meanOf(const TestCase& c, const Points<2>& value, const std::string& material) {
    const auto nodes = nodesOf(c, material);
    Vec<2> sum = Vec<2>::Zero();
    for (const int i : nodes) sum += value[i];
    return sum / static_cast<double>(nodes.size());
}

const std::string steel = "steel { type hypoelastic; rho 2000; E 1e7; nu 0.3; }";
const std::string stone = "stone { type rigid; rho 2000; }";

/// Bring a solid by `shift` to another place, its reference positions, too.
void displace(TestCase& c, const std::string& material, const Vec<2>& shift) {
    for (const int i : nodesOf(c, material)) {
        c.state.nodes.x[i] += shift;
        c.state.nodes.X[i] += shift;
    }
}

/// A block on a plane that falls to the right by `angle`.
TestCase onIncline(double angle, double friction, const std::string& material, const std::string& name) {
    const Vec<2> left = Eigen::Rotation2Dd(-angle) * Vec<2>(-2, 0), right = Eigen::Rotation2Dd(-angle) * Vec<2>(4, 0);
    TestCase c = makeCase("meshSize 0.1; bodies ( block { type solid; material " + name + "; " +
                              turned(-angle, -0.2, 0.1, 0.2, 0.3) + " } ); walls ( plane { points (" +
                              point(left[0], left[1]) + point(right[0], right[1]) + "); } );",
                          material, "plane { type slip; }", {0, -10});
    displace(c, name, Eigen::Rotation2Dd(-angle) * Vec<2>(0, -0.1 + 1e-6));
    c.problem.contact = {true, friction};
    return c;
}

class Incline : public testing::TestWithParam<bool> {};

TEST_P(Incline, blocksSlideAndStickByCoulomb) {
    const bool rigid = GetParam();
    const double angle = 0.5;
    for (const double friction : {0.0, 0.3, 0.7}) {
        TestCase c = onIncline(angle, friction, rigid ? stone : steel, rigid ? "stone" : "steel");
        const std::string name = rigid ? "stone" : "steel";
        const double dt = rigid ? 2e-3 : 5e-4, time = 0.2;
        for (double t = 0; t < 0.5 * time; t += dt) ASSERT_EQ(c.step(dt).rejected, 0);
        const Vec<2> x0 = meanOf(c, c.state.nodes.x, name), v0 = meanOf(c, c.state.nodes.v, name);
        const double t0 = c.state.time.value;
        for (double t = 0; t < time; t += dt) ASSERT_EQ(c.step(dt).rejected, 0);
        const Vec<2> along = Eigen::Rotation2Dd(-angle) * Vec<2>(1, 0);
        const double a = (meanOf(c, c.state.nodes.v, name) - v0).dot(along) / (c.state.time.value - t0);
        const double expected = std::max(0.0, 10 * (std::sin(angle) - friction * std::cos(angle)));
        std::cout << name << " mu " << friction << ": acceleration " << a << ", expected " << expected << "\n";
        if (expected > 0) {
            EXPECT_NEAR(a, expected, 0.005 * expected);
        } else {
            EXPECT_LT((meanOf(c, c.state.nodes.x, name) - x0).norm(), 1e-5);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(, Incline, testing::Bool(),
                         [](const auto& test) { return std::string(test.param ? "rigid" : "elastic"); });

TEST(SolidContact, fallenBlocksLieStill) {
    for (const bool rigid : {true, false}) {
        const std::string name = rigid ? "stone" : "steel";
        TestCase c =
            makeCase("meshSize 0.1; bodies ( block { type solid; material " + name + "; " +
                         rectangle(0.3, 0.1, 0.7, 0.3) + " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                     stone + steel, "tank { type slip; }", {0, -10});
        c.problem.contact = {true, 0.3};
        const double dt = rigid ? 2e-3 : 1e-3;
        double lowest = 1;
        for (double t = 0; t < (rigid ? 0.3 : 1.0); t += dt) {
            ASSERT_EQ(c.step(dt).rejected, 0);
            for (const int i : c.state.mesh.solid.nodes[0]) lowest = std::min(lowest, c.state.nodes.x[i][1]);
        }
        EXPECT_GT(lowest, -1e-4);
        const double height = c.state.nodes.x[nearestNode(c.state.nodes.X, {0.3, 0.1})][1];
        std::cout << name << ": lowest " << lowest << ", at the end " << height << "\n";
        if (rigid) {
            EXPECT_NEAR(height, 0, 1e-6);
            EXPECT_LT(largest(c.state.nodes.v), 1e-10);
        }
    }
}

TEST(SolidContact, barsThatMeetEndToEndExchangeTheirVelocities) {
    // plane strain between slip sides, nu 0: c = sqrt(E/rho), contact for 2 L/c
    const double speed = 0.1, sound = std::sqrt(1e7 / 1000), length = 1;
    TestCase c = makeCase(
        "meshSize 0.02; bodies ("
        " left { type solid; material a; pattern checkerboard; cells (50 1); velocity (0.1 0); " +
            rectangle(-1, 0, 0, 0.02) +
            " patches { sides { edges ((0 1) (2 3)); } } }"
            " right { type solid; material b; pattern checkerboard; cells (50 1); velocity (-0.1 0); " +
            rectangle(0.1, 0, 1.1, 0.02) + " patches { sides { edges ((0 1) (2 3)); } } } );",
        "a { type hypoelastic; rho 1000; E 1e7; nu 0; } b { type hypoelastic; rho 1000; E 1e7; nu 0; }",
        "sides { type symmetry; }", {0, 0});
    displace(c, "b", {-0.1 + 6e-5, 0});
    c.problem.contact = {true, 0};
    c.tolerance(1e-9);
    const double dt = 5e-5;
    const int i = nearestNode(c.state.nodes.X, {0, 0}), j = nearestNode(c.state.nodes.X, {6e-5, 0});
    double first = 0, last = 0;
    for (double t = 0; t < 0.04; t += dt) {
        const auto report = c.step(dt);
        ASSERT_EQ(report.rejected, 0) << t << ": " << report.reasons.front();
        const double gap = c.state.nodes.x[j][0] - c.state.nodes.x[i][0];
        ASSERT_GT(gap, 0);
        if (gap < 2e-5 + 1e-7) {  // solids keep 1e-3 h
            if (first == 0) first = c.state.time.value;
            last = c.state.time.value;
        }
    }
    const Vec<2> left = meanOf(c, c.state.nodes.v, "a"), right = meanOf(c, c.state.nodes.v, "b");
    std::cout << "contact for " << last - first << " s (" << 2 * length / sound << "), velocities after "
              << left.transpose() << ", " << right.transpose() << "\n";
    EXPECT_NEAR(last - first, 2 * length / sound, 0.02 * 2 * length / sound);
    EXPECT_NEAR(left[0] + right[0], 0, 1e-10 * speed);
    EXPECT_NEAR(right[0], speed, 0.05 * speed);  // the rest is in the bars' own waves and the damper
}

}  // namespace
