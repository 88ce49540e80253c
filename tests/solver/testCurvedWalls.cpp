// Slippery walls that are bent: they neither hold the water nor drive it.

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double R = 0.5, g = 9.81;

/// A half-full horizontal round tank, its surface turned by `tilt`; both of pieces of `piece` [degrees].
TestCase roundTank(double h, double piece, double tilt) {
    const auto point = [](double degrees) {
        char text[64];
        std::snprintf(text, sizeof text, "(%.15g %.15g) ", R * std::cos(degrees * M_PI / 180),
                      R * std::sin(degrees * M_PI / 180));
        return std::string(text);
    };
    std::string wall, water;
    for (double a = 135; a < 405 + 1e-9; a += piece) {
        wall += point(a);
        if (a > 180 + tilt - 1e-9 && a < 360 + tilt + 1e-9) water += point(a);
    }
    return makeCase("meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; vertices (" +
                        water + "); } ); walls ( tank { points (" + wall + "); } );",
                    test::water, "tank { type slip; }");
}

// Hydrostatic pressure is balanced to round-off although every chord of the wall has another normal.
TEST(CurvedWalls, stillWaterStaysStill) {
    for (const double piece : {5.0, 15.0}) {
        TestCase c = roundTank(0.06, piece, 0);
        c.start(5e-3);
        const double volume = totalVolume<2>(c.state);
        for (int n = 0; n < 100; ++n) c.step(5e-3);
        EXPECT_LT(largest(c.state.nodes.v), 1e-8) << piece;
        EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-12);
    }
}

/// Moment of the surface's height about the middle.
double tiltOf(const TestCase& c) {
    const auto topology = c.topology();
    double sum = 0;
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const Vec<2>&b = c.state.nodes.x[face.nodes[0]], &a = c.state.nodes.x[face.nodes[1]];
        sum += 0.5 * (b[0] - a[0]) * (a[0] * a[1] + b[0] * b[1]);
    }
    return sum;
}

// The first sloshing mode of a half-full round tank: omega^2 R/g = 1.35573 (Evans and Linton 1993).
TEST(CurvedWalls, roundTankSloshes) {
    TestCase c = roundTank(0.04, 2.5, 2.5);
    const double theory = std::sqrt(1.35573 * g / R), dt = 0.01;
    c.start(dt);
    std::vector<double> t, y;
    int rejected = 0;
    while (c.state.time.value < 4) {
        rejected += c.step(dt).rejected;
        t.push_back(c.state.time.value);
        y.push_back(tiltOf(c));
    }
    const auto fit = fitHarmonic(t, y, 3, 8);
    double late = 0;
    for (std::size_t k = 0; k < t.size(); ++k)
        if (t[k] > 4 - 2 * M_PI / theory) late = std::max(late, std::abs(y[k] - fit.mean));
    std::cout << "period " << theory / fit.omega << " of theory, last amplitude " << late / std::abs(y[0] - fit.mean)
              << " of the first\n";
    EXPECT_EQ(rejected, 0);
    EXPECT_NEAR(fit.omega, theory, 0.01 * theory);
    EXPECT_NEAR(late, std::abs(y[0] - fit.mean), 0.03 * late);
}

/// How far the front of a collapsed column has come on a floor with bends of `angle` [degrees] every 0.875 a.
double frontOver(double angle, double h) {
    const double a = 0.05715, end = 0.23;
    std::string floor = "(0 0.3) (0 0) ";
    for (int k = 1; k <= 16; ++k)
        floor += "(" + std::to_string(0.05 * (k + 1)) + " " +
                 std::to_string(k % 2 ? 0.0 : 0.05 * std::tan(0.5 * angle * M_PI / 180)) + ") ";
    TestCase c = makeCase("meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " +
                              rectangle(0, 0, a, 2 * a) + " } ); walls ( tank { points (" + floor + "); } );",
                          water, "tank { type slip; }");
    const double dt = 1e-3;
    c.start(dt);
    while (c.state.time.value < end - 0.5 * dt) c.step(dt);
    const auto topology = c.topology();
    double front = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i)) front = std::max(front, c.state.nodes.x[i][0]);
    return front;
}

// Bends of a slip floor do not hold the front. (Where corners were nodes it stayed behind by a fifth.)
TEST(CurvedWalls, bendsDoNotHold) {
    double smooth = 0, bent = 0;
    for (const double h : {0.0057, 0.006, 0.0063}) {
        smooth += frontOver(0, h) / 3;
        bent += frontOver(1, h) / 3;
    }
    std::cout << "front " << bent / smooth << " of that over a smooth floor\n";
    EXPECT_NEAR(bent, smooth, 5e-3 * smooth);
}

// A submerged step: the water in its convex corner rests; when it flows, it goes round.
TEST(CurvedWalls, waterFlowsRoundAConvexCorner) {
    TestCase c = makeCase(
        "meshSize 0.05; bodies ( water { type fluid; material water; vertices ((0 0) (0.5 0) (0.5 0.2) "
        "(1 0.2) (1 0.5) (0 0.5)); } ); walls ( tank { points ((0 1) (0 0) (0.5 0) (0.5 0.2) (1 0.2) (1 "
        "1)); } );",
        water, "tank { type slip; }");
    c.start(2e-3);
    for (int n = 0; n < 50; ++n) c.step(2e-3);
    EXPECT_LT(largest(c.state.nodes.v), 1e-8);
    const Id corner = c.state.nodes.id[nearestNode(c.state.nodes.x, {0.5, 0.2})];
    const double volume = totalVolume<2>(c.state);
    c.problem.gravity = {4, -9};  // to the right, onto the step
    for (int n = 0; n < 150; ++n) c.step(2e-3);
    const int node = nodeOf(c.state.nodes, corner);
    ASSERT_TRUE(node < 0 || (c.state.nodes.x[node] - Vec<2>(0.5, 0.2)).norm() > 0.01);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 0.01 * volume);
}

}  // namespace
