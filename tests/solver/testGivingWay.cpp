// Walls that give way to waves: what they see of the water, in both dimensions; and a run that is cut in two.

#include <gtest/gtest.h>

#include "conditions/wallMotion.hpp"
#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "solver/checkMotions.hpp"
#include "support/cases.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double depth = 0.35, dt = 0.01;  // the water is 0.4 m deep
const std::string givesWay = "type slip; motion { absorb { depth 0.35; period 1.2; } }";

/// A tank whose left wall is a patch of its own.
TestCase plane(const std::string& right = "type slip;") {
    TestCase c =
        makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.4) +
                     " } ); walls ( left { moving true; points ((0 0.8) (0 0)); } bed { points ((-0.3 0) (1.3 0)); } "
                     "right { moving true; points ((1 0) (1 0.8)); } );",
                 water, "left { " + givesWay + " } bed { type slip; } right { " + right + " }");
    c.start(dt);
    return c;
}

TestCase3 space() {
    TestCase3 c = boxOfWater({0.6, 0.3, 0.4}, {0.6, 0.3, 0.8}, 0.1);
    auto& tank = c.state.mesh.patches[0].faces;
    Patch<3> left{"left", {}};
    for (std::size_t f = tank.size(); f-- > 0;)
        if (std::all_of(tank[f].begin(), tank[f].end(), [&](int i) { return c.state.nodes.x[i][0] == 0; })) {
            left.faces.push_back(tank[f]);
            tank.erase(tank.begin() + static_cast<std::ptrdiff_t>(f));
        }
    c.state.mesh.patches.push_back(left);
    c.problem.conditions = readBoundaryConditions<3>(
        Dictionary::parse("tank { type slip; } left { " + givesWay + " }", "boundaryConditions"), c.state.mesh.patches);
    for (auto& supports : c.state.nodes.wall) supports = unsupported<3>();  // counted anew
    separateFromWalls<3>(std::vector<bool>(c.state.mesh.patches.size(), true), c.state);
    return c;
}

/// Velocity that the patch gets in the next step.
template <int Dim, class Case>
Vec<Dim> velocityOf(const Case& c, int patch) {
    const auto constraints =
        nodeConstraints<Dim>(c.state.mesh, c.problem.conditions, c.topology(), c.state.nodes, 0, dt);
    return constraints.motion[patch].velocity;
}

// Water at rest that is 5 cm too high, and then rises: the wall goes back by the law, in space as in the plane, however
// wide it is.
TEST(GivingWay, theWallSeesTheWaterBeforeIt) {
    const Absorption wall =
        *WallMotion(Dictionary::parse("absorb { depth 0.35; period 1.2; }", "m"), true).absorption();
    TestCase p = plane();
    TestCase3 s = space();
    const double still = wall.answer(0, 0, 0.05, dt);
    EXPECT_LT(still, 0);
    EXPECT_NEAR(velocityOf<2>(p, 0)[0], still, 1e-12);
    EXPECT_NEAR(velocityOf<3>(s, 1)[0], still, 1e-12);
    for (auto& v : p.state.nodes.v) v = {0, 0.2};
    for (auto& v : s.state.nodes.v) v = {0, 0, 0.2};
    // the whole water goes up, bed and all: only what is stretched counts
    EXPECT_NEAR(velocityOf<2>(p, 0)[0], still, 1e-12);
    for (int i = 0; i < p.state.nodes.size(); ++i) p.state.nodes.v[i] *= p.state.nodes.x[i][1] / 0.4;
    for (int i = 0; i < s.state.nodes.size(); ++i) s.state.nodes.v[i] *= s.state.nodes.x[i][2] / 0.4;
    const double rising = wall.answer(0, 0, 0.05 + 0.2 * wall.ahead(dt), dt);
    EXPECT_LT(rising, still);
    EXPECT_NEAR(velocityOf<2>(p, 0)[0], rising, 1e-12);
    EXPECT_NEAR(velocityOf<3>(s, 1)[0], rising, 1e-12);
}

// Faces between periodic sides stand out on one side and in on the other: the height is the same.
TEST(GivingWay, betweenRaggedSides) {
    TestCase3 c = space();
    const double still = velocityOf<3>(c, 1)[0];
    for (auto& x : c.state.nodes.x)
        if (x[0] == 0 && (x[1] < 0.01 || x[1] > 0.29) && std::abs(x[2] - 0.1) < 0.01) x[1] += 0.05;
    EXPECT_NEAR(velocityOf<3>(c, 1)[0], still, 1e-12);
}

// Of water of even depth the height is right on an inclined wall, too.
TEST(GivingWay, anInclinedWall) {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; vertices ((0 0) (1 0) (1 0.4) (-0.2 0.4)); "
        "} ); walls ( left { moving true; points ((-0.4 0.8) (0 0)); } bed { points ((-0.5 0) (1 0)); } right { "
        "points ((1 0) (1 0.8)); } );",
        water, "left { " + givesWay + " } bed { type slip; } right { type slip; }");
    const Absorption wall =
        *WallMotion(Dictionary::parse("absorb { depth 0.35; period 1.2; }", "m"), true).absorption();
    EXPECT_NEAR(velocityOf<2>(c, 0)[0], wall.answer(0, 0, 0.05, dt), 1e-12);
    EXPECT_EQ(velocityOf<2>(c, 0)[1], 0);
}

// A dry wall comes back to its place and makes no waves for want of water.
TEST(GivingWay, aDryWallRests) {
    TestCase c = plane();
    for (auto& supports : c.state.nodes.wall) supports = unsupported<2>();
    EXPECT_EQ(velocityOf<2>(c, 0)[0], 0);
}

// It makes room until the water is as deep as it should be: 0.4 m over 1 m become 0.35 m over 1.143 m.
TEST(GivingWay, waterThatIsTooDeepFindsItsLevel) {
    TestCase c = plane();
    for (int n = 0; n < 3000; ++n) c.step(dt);
    double left = 1, top = 0;
    for (const int i : c.state.mesh.patches[0].faces.front()) left = std::min(left, c.state.nodes.x[i][0]);
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i)) top = std::max(top, c.state.nodes.x[i][1]);
    EXPECT_NEAR(top, 0.4 / (1 - left), 2e-3);
    EXPECT_LT(top, 0.365);  // the return holds it off a little
    EXPECT_GT(top, depth);
}

TEST(GivingWay, onlyUprightWallsDo) {
    const std::string tub = "tub { " + givesWay + " }";
    const TestCase c =
        makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.4) +
                     " } ); walls ( tub { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                 water, tub);
    EXPECT_THROW(checkMotions<2>(Dictionary::parse(tub, "boundaryConditions"), c.problem.conditions, c.state),
                 UserError);
    EXPECT_THROW(makeCase("meshSize 0.25; bodies ( bar { type solid; material rubber; " + rectangle(0, 0, 1, 0.25) +
                              " patches { left { edges ((3 0)); } } } );",
                          rubber, "left { type clamped; motion { absorb { depth 1; period 1; } } }"),
                 UserError);
}

TEST(GivingWay, aRestartIsTheRunItself) {
    const TemporaryFolder folder;
    TestCase c = plane(givesWay);
    for (int n = 0; n < 10; ++n) c.step(dt);
    writeState(folder.path() / "0.1", c.state);
    TestCase again = c;
    again.state = readState<2>(folder.path() / "0.1");
    for (int n = 0; n < 20; ++n) {
        c.step(dt);
        again.step(dt);
    }
    expectIdentical(c.state, again.state);
}

}  // namespace
