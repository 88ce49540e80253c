// Solids in lasting contact: stacks, pressure of contact, a body against itself.

#include <gtest/gtest.h>

#include "functions/balance.hpp"
#include "support/solids.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TEST(ContactAtRest, aStackOfFiveBlocksLiesStill) {
    std::string bodies;
    for (int k = 0; k < 5; ++k)
        bodies += "b" + std::to_string(k) + " { type solid; material stone" + std::to_string(k) +
                  "; pattern checkerboard; cells (2 1); " + rectangle(0.3, 0.05 + 0.3 * k, 0.7, 0.25 + 0.3 * k) + " }";
    std::string laws;
    for (int k = 0; k < 5; ++k) laws += "stone" + std::to_string(k) + " { type rigid; rho 2000; }";
    TestCase c =
        makeCase("meshSize 0.2; bodies (" + bodies + "); walls ( floor { points ((0 2) (0 0) (1 0) (1 2)); } );", laws,
                 "floor { type slip; }", {0, -10});
    for (int k = 0; k < 5; ++k)
        displace(c, "stone" + std::to_string(k), {0.01 * (k % 2), -0.05 - 0.1 * k + 4e-4 * (k + 1)});
    c.problem.contact = {true, 0.3};
    const double dt = 0.01;
    int n = 0;
    for (; n < 100; ++n) ASSERT_EQ(c.step(dt).rejected, 0);  // they come to rest
    double fastest = 0;
    const Points<2> x = c.state.nodes.x;
    for (; n < 1100; ++n) {
        ASSERT_EQ(c.step(dt).rejected, 0);
        fastest = std::max(fastest, largest(c.state.nodes.v));
    }
    double moved = 0;
    for (std::size_t i = 0; i < x.size(); ++i) moved = std::max(moved, (c.state.nodes.x[i] - x[i]).norm());
    std::cout << "stack: fastest " << fastest << " m/s in 10 s, moved " << moved << " m, in walls " << depthInWalls(c)
              << " h, in solids " << depthInSolids(c) << " h\n";
    EXPECT_LT(fastest, 1e-6);
    EXPECT_LT(moved, 1e-6);
    EXPECT_LT(depthInWalls(c), 1e-3);
    EXPECT_LT(depthInSolids(c), 1e-3);
}

struct HertzContact {
    double halfWidth = 0, peak = 0;
};

/// Half a disc of radius 1 pressed on a plane by P per metre: p = p0 sqrt(1 - (x/a)^2), fitted to the plane's forces.
HertzContact hertz(double fine, double load) {
    const auto n = [](double value) { return std::to_string(value); };
    TestCase c = makeCase(
        "meshSize 0.15; bodies ( disc { type solid; material rubber; vertices ((1 0) (-1 0) (0 -1)); edges (arc 1 2 "
        "(-0.7071067811865 -0.7071067811865) arc 2 0 (0.7071067811865 -0.7071067811865)); "
        "patches { top { edges ((0 1)); } } } ); walls ( plane { points ((-2 -1.1) (2 -1.1)); } ); "
        "refinements { foot { type box; min (-0.15 -1.05); max (0.15 -0.95); meshSize " +
            n(fine) + "; } }",
        "rubber { type hypoelastic; rho 1000; E 1e7; nu 0.3; }",
        "top { type traction; traction (0 " + n(-load / 2) + " 0); } plane { type slip; }", {0, 0});
    displace(c, "rubber", {0, -0.1 + 1e-7});
    c.problem.contact = {true, 0};
    c.controls.timeIntegration.gamma = 1;  // damps: the disc comes to rest
    c.tolerance(1e-8);
    for (int k = 0; k < 100; ++k) c.step(0.01);
    const auto force = supportForces<2>(c.problem, c.controls, c.state);
    std::vector<std::pair<double, double>> found;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (c.topology().onSolid[i] && c.state.nodes.x[i][1] < -1.1 + 1e-6)
            found.emplace_back(c.state.nodes.x[i][0], force[i][1]);
    std::sort(found.begin(), found.end());
    double A = 0, B = 0, D = 0, b0 = 0, b1 = 0, total = 0;  // p^2 = p0^2 - (p0/a)^2 x^2
    for (std::size_t k = 1; k + 1 < found.size(); ++k) {
        const auto [x, f] = found[k];
        const double p = f / (0.5 * (found[k + 1].first - found[k - 1].first));
        total += f;
        A += 1;
        B += x * x;
        D += x * x * x * x;
        b0 += p * p;
        b1 += p * p * x * x;
    }
    const double det = A * D - B * B, p2 = (b0 * D - b1 * B) / det, slope = (A * b1 - B * b0) / det;
    std::cout << found.size() << " nodes in contact, force " << total << " (" << load << "), fastest "
              << largest(c.state.nodes.v) << " m/s\n";
    return {std::sqrt(-p2 / slope), std::sqrt(p2)};
}

TEST(ContactAtRest, hertzHalfDisc) {
    const double stiffness = 1e7 / (1 - 0.09), a = 0.1, load = M_PI * stiffness * a * a / 4, p0 = 2 * load / (M_PI * a);
    double before = 1;  // error of the mesh before
    for (const double fine : {0.02, 0.01}) {
        const auto [width, peak] = hertz(fine, load);
        std::cout << "h " << fine << ": half width " << width << " (" << a << "), peak " << peak << " (" << p0 << ")\n";
        const double error = std::max(std::abs(width / a - 1), std::abs(peak / p0 - 1));
        EXPECT_LT(error, 0.03);
        EXPECT_LT(error, 0.6 * before);
        before = error;
    }
}

// A ring between plates that come together by more than its hole: it meets itself.
TEST(ContactAtRest, aRingIsPressedAgainstItself) {
    TestCase c = makeCase(
        "meshSize 0.05; bodies ( lower { type solid; material rubber; vertices ((-0.5 0) (0.5 0) (0.4 0) (-0.4 0)); "
        "edges (arc 0 1 (0 -0.5) arc 2 3 (0 -0.4)); } upper { type solid; material rubber; vertices ((0.5 0) (-0.5 0) "
        "(-0.4 0) (0.4 0)); edges (arc 0 1 (0 0.5) arc 2 3 (0 0.4)); } ); walls ( low { points ((-2 -0.51) (2 "
        "-0.51)); } high { points ((2 0.51) (-2 0.51)); } );",
        "rubber { type neoHookean; rho 1000; E 1e6; nu 0.3; }",
        "low { type slip; } high { type slip; motion { velocity (0 -1 0); } }", {0, 0});
    c.problem.contact = {true, 0.2};
    const double dt = 1e-3;
    double inWalls = 0, inSolid = 0;
    int rejected = 0;
    while (c.state.time.value < 0.8) {
        rejected += c.step(dt).rejected;
        inWalls = std::max(inWalls, depthInWalls(c));
        inSolid = std::max(inSolid, depthInSolids(c));
    }
    std::cout << "ring: " << rejected << " rejected, in walls " << inWalls << " h, in itself " << inSolid << " h\n";
    EXPECT_LT(inWalls, 1e-3);
    EXPECT_LT(inSolid, 1e-3);
}

}  // namespace
