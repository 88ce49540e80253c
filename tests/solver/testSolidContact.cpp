// Contact of solids with walls and with each other: closed forms.

#include <gtest/gtest.h>

#include "support/solids.hpp"
#include "walls/skins.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

const std::string steel = "steel { type hypoelastic; rho 2000; E 1e7; nu 0.3; }";
const std::string stone = "stone { type rigid; rho 2000; }";

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

// A diamond of rubber falls beside a pool: with contact it lands on its corner, without it the run ends with a message.
TEST(SolidContact, aSolidMeetsTheFloor) {
    TestCase c =
        makeCase("meshSize 0.02; bodies ( pool { type fluid; material water; " + rectangle(0, 0, 0.2, 0.1) +
                     " } s { type solid; material rubber; vertices ((0.4 0.05) (0.5 0.15) (0.4 0.25) (0.3 0.15)); } ); "
                     "walls ( tank { points ((0 0.7) (0 0) (0.8 0) (0.8 0.7)); } );",
                 water + rubber, "tank { type slip; }");
    TestCase without = c;
    c.problem.contact = {true, 0.3};
    int rejected = 0;
    double inWalls = 0;
    while (c.state.time.value < 0.25) {
        rejected += c.step(1e-3).rejected;
        inWalls = std::max(inWalls, depthInWalls(c));
    }
    std::cout << "diamond: " << rejected << " rejected, in walls " << inWalls << " h\n";
    EXPECT_LE(rejected, 2);
    EXPECT_LT(inWalls, 1e-3);
    try {
        while (without.state.time.value < 0.25) without.step(1e-3);
        ADD_FAILURE() << "it went through the floor";
    } catch (const StepFailure& failure) {
        const std::string text = failure.what();
        EXPECT_NE(text.find("solid 'rubber' went through the wall 'tank'"), std::string::npos) << text;
    }
}

/// A block of iron in a tank that it sinks in, turned by `angle`.
TestCase sinking(double angle, double x, double y, const std::string& law, const std::string& skin) {
    std::string vertices;
    for (const Vec<2>& corner :
         {Vec<2>(-0.05, -0.025), Vec<2>(0.05, -0.025), Vec<2>(0.05, 0.025), Vec<2>(-0.05, 0.025)}) {
        const Vec<2> p = Vec<2>(x, y) + Eigen::Rotation2Dd(angle) * corner;
        vertices += point(p[0], p[1]);
    }
    TestCase c = makeCase("meshSize 0.02; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.4, 0.3) +
                              " holes (block); } block { type solid; material iron; vertices (" + vertices +
                              "); patches { skin { edges ((0 1) (1 2) (2 3) (3 0)); } } } ); walls ( tank { points ((0 "
                              "0.6) (0 0) (0.4 0) (0.4 0.6)); } );",
                          water + "iron { rho 3000; " + law + " }", "tank { type slip; } skin { " + skin + " }");
    separateFromSkins<2>(c.kinds(), c.state);
    c.problem.contact = {true, 0.3};
    return c;
}

// The water under it gets out, whether it sticks to the block or slides over it. (The edge from a corner that has come
// down to a node of the floor used to be divided where the last triangle between them had just gone: 3 of 10 ended so.)
TEST(SolidContact, whatSinksComesToLieOnTheFloor) {
    const std::string rigid = "type rigid;", elastic = "type hypoelastic; E 1e7; nu 0.3;";
    for (const std::string skin : {"type traction; traction (0 0 0);", "type slipInterface;"})
        for (const auto& [angle, law] : {std::pair(0.0, rigid), {0.0145, rigid}, {-0.33, rigid}, {0.2, elastic}}) {
            TestCase c = sinking(angle, 0.2, 0.14, law, skin);
            c.start(1e-3);
            int steps = 0, rejected = 0;
            double deepest = 1;
            for (; c.state.time.value < 1; ++steps) {
                const auto rate = courantRate<2>(c.state);
                rejected +=
                    c.step(1 / std::max({250.0, rate.largest / 0.4, rate.relative / 0.2, rate.compression / 0.7}))
                        .rejected;
                for (const int i : nodesOf(c, "iron")) deepest = std::min(deepest, c.state.nodes.x[i][1]);
            }
            double highest = 0, lowest = 1;
            for (const int i : nodesOf(c, "iron")) {
                highest = std::max(highest, c.state.nodes.x[i][1]);
                lowest = std::min(lowest, c.state.nodes.x[i][1]);
            }
            const double speed = meanOf(c, c.state.nodes.v, "iron").norm();
            std::cout << skin << " turned by " << angle << ", " << law << " " << steps << " steps, " << rejected
                      << " rejected, from " << lowest << " to " << highest << " m, " << speed << " m/s, deepest "
                      << deepest << " m, volume " << 100 * c.ledgerSum() / 0.115 << " %\n";
            EXPECT_NEAR(lowest, 0, 1e-4);
            EXPECT_NEAR(highest, 0.05, 2e-4);
            EXPECT_LT(speed, law == rigid ? 1e-10 : 0.01);  // an elastic one swings on
            EXPECT_GT(deepest, -1e-3 * 0.02);
            EXPECT_LT(rejected, 0.05 * steps);
            EXPECT_LT(std::abs(c.ledgerSum()), 0.001 * 0.115);  // what was under it is beside it
            EXPECT_EQ(c.state.ledger[VolumeCause::gone], 0);
        }
}

// The wedge of the water entry, in a basin so shallow that it strikes its bottom.
TEST(SolidContact, aWedgeStrikesTheBottomOfItsBasin) {
    TestCase c = makeCase("meshSize 0.06; bodies ( water { type fluid; material water; " + rectangle(-1, -0.3, 1, 0) +
                              " } wedge { type solid; material steel; velocity (0 -5); vertices ((0 0.05) (0.6 "
                              "0.32978) (-0.6 0.32978)); } ); walls ( "
                              "basin { points ((-1 1) (-1 -0.3) (1 -0.3) (1 1)); } );",
                          water + "steel { type hypoelastic; rho 1500; E 1e8; nu 0; }", "basin { type slip; }");
    c.problem.contact = {true, 0.3};
    const double dt = 5e-4;
    c.start(dt);
    double inWalls = 0, energy = 1e300, growth = 0, lowest = 1;
    int rejected = 0;
    const double first = solidEnergy(c);
    for (int n = 0; n < 600; ++n) {
        rejected += c.step(dt).rejected;
        inWalls = std::max(inWalls, depthInWalls(c));
        double all = storedEnergy<2>(c.problem, c.controls, c.state).total() - c.state.energy.sum(CauseKind::passage);
        growth = std::max(growth, all - energy);
        energy = std::min(energy, all);
        for (const int i : nodesOf(c, "steel")) lowest = std::min(lowest, c.state.nodes.x[i][1]);
    }
    std::cout << "wedge: " << rejected << " rejected, lowest " << lowest << ", in walls " << inWalls
              << " h, energy grew by " << growth / first << " of the first\n";
    EXPECT_LT(lowest, -0.2999);
    EXPECT_LT(inWalls, 1e-3);
    EXPECT_LT(growth, 1e-10 * first);
    EXPECT_LE(rejected, 6);
}

}  // namespace
