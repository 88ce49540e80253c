// A wedge enters water: as a rigid body, and as an elastic one that hardly bends.

#include <gtest/gtest.h>

#include "support/solids.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

struct Entry {
    std::vector<double> velocity;  // of the wedge's centre, every step
    int iterations = 0;
};

constexpr double speed = 5.05;

/// A wedge of 25 degrees that enters water.
Entry entryOf(const std::string& law, const std::string& h) {
    TestCase c =
        makeCase("meshSize " + h + "; bodies ( water { type fluid; material water; " + rectangle(-1.25, -1.1, 1.25, 0) +
                     " } wedge { type solid; material steel; velocity (0 -" + std::to_string(speed) +
                     "); vertices ((0 0.03) (0.6 "
                     "0.30978) (-0.6 0.30978)); } ); walls ( "
                     "basin { points ((-1.25 1) (-1.25 -1.1) (1.25 -1.1) (1.25 1)); } );",
                 water + "steel { rho 466.07; " + law + " }", "basin { type slip; }");
    Entry entry;
    c.start(5e-4);
    while (c.state.time.value < 0.04) {
        const auto report = c.step(5e-4);
        EXPECT_EQ(report.rejected, 0);
        entry.iterations += report.step.iterations;
        entry.velocity.push_back(meanOf(c, c.state.nodes.v, "steel")[1]);
    }
    std::cout << "h " << h << ", " << law << ": " << entry.iterations << " iterations\n";
    return entry;
}

/// Rounds that a wedge of this stiffness takes, which goes in as the rigid one.
int roundsLikeRigid(const Entry& rigid, const std::string& h, const std::string& modulus, double apart) {
    const Entry stiff = entryOf("type hypoelastic; nu 0; E " + modulus + ";", h);
    double most = 0;
    for (std::size_t k = 0; k < stiff.velocity.size(); ++k)
        most = std::max(most, std::abs(stiff.velocity[k] - rigid.velocity.at(k)) / speed);
    std::cout << "apart by " << most << "\n";
    EXPECT_LT(most, apart);
    EXPECT_LT(std::abs(rigid.velocity.back()), 0.5 * speed);  // it has been slowed
    return stiff.iterations;
}

// One of 1e9 Pa is 2.7 % of the speed apart at times: it bends.
TEST(WedgeEntry, aRigidWedgeGoesInAsAVeryStiffOne) {
    const Entry coarse = entryOf("type rigid;", "0.06"), fine = entryOf("type rigid;", "0.03");
    EXPECT_LT(coarse.iterations, roundsLikeRigid(coarse, "0.06", "1e10", 0.01));
    EXPECT_LT(coarse.iterations, roundsLikeRigid(coarse, "0.06", "1e11", 0.005));
    EXPECT_LT(fine.iterations, 1.01 * roundsLikeRigid(fine, "0.03", "1e11", 0.01));
}

}  // namespace
