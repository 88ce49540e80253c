// Nodes that slide over walls and land on them: corners, edges, walls that others hold, in two and three dimensions.

#include "walls/landing.hpp"

#include <gtest/gtest.h>

#include "support/cases.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81;

/// A square of water that floats before the empty corner (1, 0) of a tank.
TestCase beforeACorner() {
    return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0.4, 0.1, 0.9, 0.6) +
                        " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                    water, "tank { type slip; }");
}

/// Water over and beside a step whose convex corner is (0.5 0.3); a node lies in it.
TestCase overAStep() {
    return makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; vertices ((0 0.3) (0.5 0.3) (0.5 0) (1 0) (1 0.6) "
        "(0 "
        "0.6)); } ); walls ( tank { points ((0 1) (0 0.3) (0.5 0.3) (0.5 0) (1 0) (1 1)); } );",
        water, "tank { type slip; }");
}

// Of two nodes that cross both walls of a corner in one step, one has the corner, the other stays before it.
TEST(Landing, onTwoWallsAtOnce) {
    TestCase c = beforeACorner();
    auto& nodes = c.state.nodes;
    const int first = nearestNode(nodes.x, {0.9, 0.1}), second = nearestNode(nodes.x, {0.9, 0.2});
    ASSERT_NE(first, second);
    const auto topology = c.topology();
    const Points<2> old = nodes.x;
    const auto moveTo = [&](int i, const Vec<2>& x) {
        nodes.x[i] = x;
        nodes.v[i] = (x - old[i]) / 0.01;
    };
    moveTo(first, {1.06, -0.04});
    moveTo(second, {1.03, -0.02});
    landOnWalls<2>(c.controls.remeshing.expert.walls, topology, old, g, c.state);
    for (const int i : {first, second}) {
        EXPECT_LE(nodes.x[i][0], 1 + 1e-12);
        EXPECT_GE(nodes.x[i][1], -1e-12);
    }
    const int early = std::min(first, second), late = std::max(first, second);
    EXPECT_LT((nodes.x[early] - Vec<2>(1, 0)).norm(), 1e-12);
    EXPECT_EQ(nSupports(nodes.wall[early]), 2);
    EXPECT_LT(nodes.v[early].norm(), 1e-9);
    EXPECT_EQ(nSupports(nodes.wall[late]), 1);
    EXPECT_NEAR((nodes.x[late] - Vec<2>(1, 0)).norm(), 0.05 * nodes.h[late], 1e-9);
}

// A node that slides along the floor through the wall at its end stays in the corner.
TEST(Landing, slidesIntoACorner) {
    TestCase c = beforeACorner();
    auto& nodes = c.state.nodes;
    const int i = nearestNode(nodes.x, {0.9, 0.1});
    Points<2> old = nodes.x;
    const auto land = [&] {
        const auto topology = c.topology();
        landOnWalls<2>(c.controls.remeshing.expert.walls, topology, old, g, c.state);
    };
    nodes.x[i] = {0.92, 0.005};
    land();
    ASSERT_EQ(nSupports(nodes.wall[i]), 1);
    EXPECT_EQ(nodes.x[i][1], 0);
    old = nodes.x;
    nodes.x[i][0] = 1.04;
    nodes.v[i] = {12, 0};
    land();
    EXPECT_LT((nodes.x[i] - Vec<2>(1, 0)).norm(), 1e-12);
    EXPECT_EQ(nSupports(nodes.wall[i]), 2);
    EXPECT_LT(nodes.v[i].norm(), 1e-12);
}

// In a convex corner calm water is held; what moves keeps the wall along which it flows.
TEST(Landing, convexCornersHoldCalmWaterAlone) {
    const auto after = [](const Vec<2>& flow) {
        TestCase c = overAStep();
        auto& nodes = c.state.nodes;
        const int i = nearestNode(nodes.x, {0.5, 0.3});
        EXPECT_EQ(nSupports(nodes.wall[i]), 2);
        const auto topology = c.topology();
        for (int s = topology.ring.start[i]; s < topology.ring.start[i + 1]; ++s) nodes.v[topology.ring.node[s]] = flow;
        const Points<2> old = nodes.x;
        landOnWalls<2>(c.controls.remeshing.expert.walls, topology, old, g, c.state);
        EXPECT_LT((nodes.x[i] - Vec<2>(0.5, 0.3)).norm(), 1e-12);
        std::vector<Vec<2>> normals;
        for (const int wall : nodes.wall[i])
            if (wall >= 0) normals.push_back(inwardNormal<2>(nodes.x, topology.walls[wall].nodes));
        return normals;
    };
    EXPECT_EQ(after({0.01, -0.01}).size(), 2u);  // slower than sqrt(g h/10) = 0.3 m/s
    const auto down = after({0.1, -1}), back = after({-1, 0.1});
    ASSERT_EQ(down.size(), 1u);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_NEAR(down[0][0], 1, 1e-12);  // along the side of the step
    EXPECT_NEAR(back[0][1], 1, 1e-12);  // along its top
}

/// The same step in space: an edge along y from (0.4, 0, 0.2) to (0.4, 0.4, 0.2).
TestCase3 overAStepInSpace() {
    TestCase3 c = boxOfWater({0.8, 0.4, 0.4}, {0.8, 0.4, 0.6}, 0.1);
    State<3> state = c.state;
    auto& cells = state.mesh.fluid.nodes;
    cells.erase(std::remove_if(cells.begin(), cells.end(),
                               [&](const auto& s) {
                                   const Vec<3> x = simplexCentroid<3>(state.nodes.x, s);
                                   return x[0] < 0.4 && x[2] < 0.2;
                               }),
                cells.end());
    state.mesh.fluid.material.resize(cells.size());
    const Vec<3> water(0.6, 0.2, 0.3);
    auto& step = state.mesh.patches[0];
    addQuad(state, step, {Vec<3>(0, 0, 0.2), Vec<3>(0.4, 0, 0.2), Vec<3>(0.4, 0.4, 0.2), Vec<3>(0, 0.4, 0.2)}, water);
    addQuad(state, step, {Vec<3>(0.4, 0, 0), Vec<3>(0.4, 0, 0.2), Vec<3>(0.4, 0.4, 0.2), Vec<3>(0.4, 0.4, 0)}, water);
    for (auto& wall : state.nodes.wall) wall = unsupported<3>();
    std::vector<bool> isWall(state.mesh.patches.size(), true);
    separateFromWalls<3>(isWall, state);
    c.state = state;
    return c;
}

TEST(Landing, convexEdgesHoldCalmWaterAlone) {
    const auto after = [](const Vec<3>& flow) {
        TestCase3 c = overAStepInSpace();
        auto& nodes = c.state.nodes;
        const auto topology = c.topology();
        int i = -1;
        for (int k = 0; k < nodes.size(); ++k)
            if (topology.wet(k) && (nodes.x[k] - Vec<3>(0.4, 0.2, 0.2)).norm() < 1e-9) i = k;
        EXPECT_EQ(nSupports(nodes.wall[i]), 2);
        for (int s = topology.ring.start[i]; s < topology.ring.start[i + 1]; ++s) nodes.v[topology.ring.node[s]] = flow;
        const Points<3> old = nodes.x;
        landOnWalls<3>(c.controls.remeshing.expert.walls, topology, old, g, c.state);
        std::vector<Vec<3>> normals;
        for (const int wall : nodes.wall[i])
            if (wall >= 0) normals.push_back(inwardNormal<3>(nodes.x, topology.walls[wall].nodes));
        return normals;
    };
    EXPECT_EQ(after({0.01, 0.02, -0.01}).size(), 2u);
    const auto down = after({0.1, 0.3, -1}), back = after({-1, 0.3, 0.1});
    ASSERT_EQ(down.size(), 1u);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_NEAR(down[0][0], 1, 1e-12);
    EXPECT_NEAR(back[0][2], 1, 1e-12);
}

/// A tetrahedron of water whose first node lies on the rim of a round tank's floor, in the middle of a chord.
TestCase3 onARim() {
    TestCase3 c;
    State<3>& state = c.state;
    state.mesh.materials = {"water"};
    const auto rim = [](double k) { return Vec<3>(std::cos(k * M_PI / 12), std::sin(k * M_PI / 12), 0); };
    const Vec<3> onRim = 0.5 * (rim(0) + rim(1)), up(0, 0, 2), middle(0, 0, 1);
    for (const Vec<3>& x : {onRim, Vec<3>(0.3, 0, 0.4), Vec<3>(0.3, 0.3, 0.5), Vec<3>(0.5, 0.1, 0.8)}) {
        state.nodes.resize(state.nodes.size() + 1);
        state.nodes.id.back() = state.nextId++;
        state.nodes.x.back() = state.nodes.X.back() = x;
        state.nodes.h.back() = 0.5;
    }
    state.mesh.fluid.nodes = {{0, 1, 2, 3}};
    if (simplexMeasure<3>(state.nodes.x, state.mesh.fluid.nodes[0]) < 0) state.mesh.fluid.nodes = {{1, 0, 2, 3}};
    state.mesh.fluid.material = {0};
    Patch<3> tank{"tank", {}};
    for (int k = 0; k < 24; ++k) {
        addQuad(state, tank, {rim(k), rim(k + 1), rim(k + 1) + up, rim(k) + up}, middle);
        Patch<3> floor = tank;
        addQuad(state, floor, {rim(k), rim(k + 1), Vec<3>::Zero(), Vec<3>::Zero()}, middle);
        tank.faces.push_back(floor.faces[tank.faces.size()]);
    }
    state.mesh.patches.push_back(tank);
    c.problem.conditions =
        readBoundaryConditions<3>(Dictionary::parse("tank { type slip; }", "boundaryConditions"), state.mesh.patches);
    separateFromWalls<3>({true}, state);
    return c;
}

// The side bulges out of the chords with which the floor ends: its edge holds what slides along it all the same.
TEST(Landing, roundRimsHoldWhatSlidesAlongThem) {
    TestCase3 c = onARim();
    auto& nodes = c.state.nodes;
    ASSERT_EQ(nSupports(nodes.wall[0]), 2);
    const double h = nodes.h[0], start = std::atan2(nodes.x[0][1], nodes.x[0][0]);
    for (int turn = 1; turn <= 10; ++turn) {  // a tenth of a chord each
        const auto topology = c.topology();
        const Points<3> old = nodes.x;
        nodes.x[0] += 0.026 * Vec<3>(-nodes.x[0][1], nodes.x[0][0], 0);
        landOnWalls<3>(c.controls.remeshing.expert.walls, topology, old, g, c.state);
        ASSERT_EQ(nSupports(nodes.wall[0]), 2) << turn;
        EXPECT_NEAR(nodes.x[0][2], 0, 1e-3 * h);
        EXPECT_NEAR(nodes.x[0].norm(), 1, 2e-3);  // chords are up to 0.009 within the circle
        EXPECT_NEAR(std::atan2(nodes.x[0][1], nodes.x[0][0]) - start, 0.026 * turn, 0.003) << turn;
    }
}

}  // namespace
