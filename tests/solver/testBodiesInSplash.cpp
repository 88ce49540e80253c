// Water throws solids against walls and each other.

#include <gtest/gtest.h>

#include "support/solids.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TEST(BodiesInSplash, aRigidBlockIsThrownAgainstAnElasticOne) {
    TestCase c = makeCase("meshSize 0.04; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.3, 0.4) +
                              " } timber { type solid; material wood; " + rectangle(0.45, 0.01, 0.65, 0.13) +
                              " } buffer { type solid; material rubber; " + rectangle(0.78, 0.01, 0.94, 0.17) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1.1 0) (1.1 1)); } );",
                          water + "wood { type rigid; rho 300; } rubber { type hypoelastic; rho 1200; E 2e5; nu 0.3; }",
                          "tank { type slip; }");
    c.problem.contact = {true, 0.3};
    int steps = 0, rejected = 0;
    double inWalls = 0, inSolids = 0;
    c.start(1e-3);
    while (c.state.time.value < 0.5) {
        const auto rate = courantRate<2>(c.state);
        const auto report =
            c.step(1 / std::max({500.0, rate.largest / 0.4, rate.relative / 0.2, rate.compression / 0.7}));
        rejected += report.rejected;
        ++steps;
        inWalls = std::max(inWalls, depthInWalls(c));
        inSolids = std::max(inSolids, depthInSolids(c));
    }
    const double moved = meanOf(c, c.state.nodes.x, "wood")[0] - meanOf(c, c.state.nodes.X, "wood")[0];
    std::cout << "splash: " << rejected << " of " << steps << " rejected, timber moved " << moved << " m, in walls "
              << inWalls << " h, in solids " << inSolids << " h, volume " << 100 * c.ledgerSum() / 0.12 << " %\n";
    EXPECT_LE(rejected, 8);
    EXPECT_GT(moved, 0.12);
    EXPECT_LT(inWalls, 1e-3);
    EXPECT_LT(inSolids, 1e-3);
    EXPECT_LT(std::abs(c.ledgerSum()), 0.03 * 0.12);
}

}  // namespace
