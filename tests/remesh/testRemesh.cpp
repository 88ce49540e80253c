// Remeshing of states: what stays, what the ledger says, nodes that cross boundaries.

#include "remesh/remesh.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mesh/locator.hpp"
#include "remesh/motionAccount.hpp"
#include "support/cases.hpp"
#include "walls/landing.hpp"
#include "walls/penetration.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

std::set<std::set<int>> cellsOf(const State<2>& state) {
    std::set<std::set<int>> cells;
    for (const auto& s : state.mesh.fluid.nodes) cells.insert({s[0], s[1], s[2]});
    return cells;
}

double areaOf(const State<2>& state) { return cellVolume<2>(state.nodes.x, state.mesh.fluid.nodes); }

TestCase tank() {
    return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                        " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                    water, "tank { type slip; }");
}

/// Water on both sides of an upright solid, two cells thick, in a tank.
TestCase divided() {
    return makeCase(
        "meshSize 0.05; bodies ("
        " left { type fluid; material water; " +
            rectangle(0, 0, 0.4, 0.4) +
            " }"
            " right { type fluid; material water; " +
            rectangle(0.44, 0, 0.84, 0.3) +
            " }"
            " wall { type solid; material rubber; meshSize 0.02; " +
            rectangle(0.4, 0, 0.44, 0.5) +
            "  patches { base { edges ((0 1)); } } } );"
            " walls ( tank { points ((0 0.7) (0 0) (0.84 0) (0.84 0.7)); } );",
        water + rubber, "tank { type slip; } base { type clamped; }");
}

TEST(Remesh, meshAtRestKeepsItsCells) {
    for (TestCase c : {tank(), divided()}) {
        const double area = areaOf(c.state);
        const auto nodes = c.state.nodes.id;
        const auto report = remesh<2>(c.controls.remeshing, c.kinds(), c.state);
        EXPECT_EQ(report.inserted, 0);
        EXPECT_EQ(report.removed, 0);
        EXPECT_EQ(c.state.nodes.id, nodes);
        EXPECT_NEAR(areaOf(c.state), area, 1e-14);
        for (const auto& [cause, amount] : c.state.ledger.byName()) EXPECT_NEAR(amount, 0, 1e-14) << cause;
        const auto cells = cellsOf(c.state);
        remesh<2>(c.controls.remeshing, c.kinds(), c.state);
        EXPECT_EQ(cellsOf(c.state), cells);  // a fixed point
    }
}

TEST(Remesh, calmMotionKeepsTheVolume) {
    // shear and stretch of a free block: the boundary moves, but what it encloses is known
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) + " } );", water, "");
    Tensor<2> F;
    F << 1.02, 0.15, -0.03, 0.99;
    for (auto& x : c.state.nodes.x) x = F * x;
    const double area = areaOf(c.state);
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    EXPECT_NEAR(areaOf(c.state), area, 1e-13);
}

// Stress that solid cells carry stays with them, bit for bit, while the fluid around loses and gains nodes.
TEST(Remesh, historyOfSolidCells) {
    TestCase c = divided();
    auto& solid = c.state.mesh.solid;
    const auto corners = [&] {  // by ids, for indices change
        std::vector<std::array<Id, 3>> ids;
        for (const auto& s : solid.nodes)
            ids.push_back({c.state.nodes.id[s[0]], c.state.nodes.id[s[1]], c.state.nodes.id[s[2]]});
        return ids;
    };
    for (int e = 0; e < solid.size(); ++e) solid.sigma.emplace_back(e + 0.1, -e, 0.3 * e, 1.0 / (e + 1));
    const auto stress = solid.sigma;
    const auto material = solid.material;
    const auto before = corners();
    // squeeze the left water to a part of its width, pull the right one up
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        auto& x = c.state.nodes.x[i];
        if (x[0] < 0.39) x = Vec<2>(0.4 - 0.4 * (0.4 - x[0]), x[1]);
        if (x[0] > 0.45) x[1] *= 2.2;
    }
    const auto report = remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    EXPECT_GT(report.removed, 0);
    EXPECT_GT(report.inserted, 0);
    EXPECT_EQ(corners(), before);
    EXPECT_EQ(solid.sigma, stress);
    EXPECT_EQ(solid.material, material);
}

TEST(Remesh, noCellCrossesAThinSolidOrAWall) {
    TestCase c = divided();
    // a wavy solid and agitated water on both sides
    for (auto& x : c.state.nodes.x)
        if (x[1] > 0.01) x[0] += 0.03 * std::sin(8 * x[1]) * x[1] / 0.5 * (x[0] > 0.02 && x[0] < 0.82);
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    const Locator<2> solid(c.state.nodes.x, c.state.mesh.solid.nodes);
    const auto topology = c.topology();
    std::vector<int> side(c.state.nodes.size(), 0);  // of the nodes of the fluid bodies off the solid
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (!topology.onSolid[i]) side[i] = c.state.nodes.X[i][0] < 0.42 ? -1 : 1;
    int interface = 0;
    for (const auto& s : c.state.mesh.fluid.nodes) {
        bool left = false, right = false;
        for (int node : s) {
            left |= side[node] < 0;
            right |= side[node] > 0;
            interface += topology.onSolid[node];
        }
        EXPECT_FALSE(left && right);
        const Vec<2> centre = simplexCentroid<2>(c.state.nodes.x, s);
        EXPECT_FALSE(solid.contains(centre));
        EXPECT_TRUE(centre[0] > 0 && centre[0] < 0.84 && centre[1] > 0);
    }
    EXPECT_GT(interface, 20);
    // the solid is untouched
    for (const auto& s : c.state.mesh.solid.nodes) EXPECT_GT(simplexMeasure<2>(c.state.nodes.x, s), 0);
}

TEST(Remesh, closeNodesGoAndLongEdgesAreHalved) {
    TestCase c = tank();
    const int i = nearestNode(c.state.nodes.x, {0.5, 0.25});
    const auto topology = c.topology();
    const int neighbour = [&] {
        for (int s = topology.fluid.start[i]; s < topology.fluid.start[i + 1]; ++s)
            for (int node : c.state.mesh.fluid.nodes[topology.fluid.cell[s]])
                if (node != i) return node;
        return -1;
    }();
    c.state.nodes.x[i] = 0.7 * c.state.nodes.x[neighbour] + 0.3 * c.state.nodes.x[i];
    const double area = areaOf(c.state);
    const int before = c.state.nodes.size();
    const Id next = c.state.nextId;
    const auto report = remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    EXPECT_GE(report.removed, 1);
    EXPECT_EQ(c.state.nodes.size(), before - report.removed + report.inserted);
    EXPECT_NEAR(areaOf(c.state), area, 1e-13);
    EXPECT_TRUE(std::is_sorted(c.state.nodes.id.begin(), c.state.nodes.id.end()));
    EXPECT_EQ(c.state.nextId, next + report.inserted);

    TestCase wide = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) + " } );", water, "");
    for (auto& x : wide.state.nodes.x) x[0] *= 1.9;
    for (int k = 0; k < wide.state.nodes.size(); ++k) {  // linear fields survive insertion
        wide.state.nodes.v[k] = {1 + wide.state.nodes.x[k][0], 2 * wide.state.nodes.x[k][1]};
        wide.state.nodes.p[k] = 5 * wide.state.nodes.x[k][1];
    }
    const double wideArea = areaOf(wide.state);
    EXPECT_GT(remesh<2>(wide.controls.remeshing, wide.kinds(), wide.state).inserted, 5);
    EXPECT_NEAR(areaOf(wide.state), wideArea, 1e-13);
    for (int k = 0; k < wide.state.nodes.size(); ++k) {
        EXPECT_NEAR(wide.state.nodes.v[k][0], 1 + wide.state.nodes.x[k][0], 1e-12);
        EXPECT_NEAR(wide.state.nodes.p[k], 5 * wide.state.nodes.x[k][1], 1e-12);
    }
}

TEST(Remesh, isolatedNodeCarriesItsVolume) {
    TestCase c = tank();
    // pull one surface node far away: it loses its triangles and becomes a drop
    const int i = nearestNode(c.state.nodes.x, {0.5, 0.5});
    c.state.nodes.x[i] += Vec<2>(0, 0.45);
    const double before = totalVolume<2>(c.state);
    remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    const auto topology = c.topology();
    EXPECT_TRUE(topology.isolated(i));
    EXPECT_GT(c.state.nodes.dropVolume[i], 0);
    EXPECT_NEAR(totalVolume<2>(c.state) - before, c.ledgerSum(), 1e-14);
}

TEST(Walls, nodeThatCrossedAWallLandsOnIt) {
    TestCase c = tank();
    const int i = nearestNode(c.state.nodes.x, {0.5, 0.1});
    const auto topology = c.topology();
    const Points<2> old = c.state.nodes.x;
    const double before = areaOf(c.state);
    c.state.nodes.x[i] = {0.5, -0.03};
    c.state.nodes.v[i] = {2, -5};
    const double moved = areaOf(c.state);
    MotionAccount<2> account(c.state);
    landOnWalls<2>(c.controls.remeshing.expert.walls, topology, old, 9.81, c.state);
    account.book(VolumeCause::landed, c.state);
    EXPECT_NEAR(c.state.nodes.x[i][1], 0, 1e-14);
    EXPECT_NEAR(c.state.nodes.x[i][0], 0.5, 1e-12);
    EXPECT_NEAR(c.state.nodes.v[i][0], 2, 1e-12);
    EXPECT_NEAR(c.state.nodes.v[i][1], 0, 1e-12);
    EXPECT_TRUE(isSupported(c.state.nodes.wall[i]));
    EXPECT_NEAR(c.state.ledger[VolumeCause::landed], areaOf(c.state) - moved, 1e-15);
    EXPECT_NE(areaOf(c.state), before);
}

TEST(Walls, nodeInASolidIsReturned) {
    TestCase c = divided();
    const auto topology = c.topology();
    const int i = nearestNode(c.state.nodes.x, {0.35, 0.2});
    ASSERT_FALSE(topology.onSolid[i]);
    c.state.nodes.x[i] = {0.405, 0.2};
    c.state.nodes.v[i] = {3, 1};
    const double moved = areaOf(c.state);
    MotionAccount<2> account(c.state);
    EXPECT_EQ(returnPenetrating<2>(topology, 0.05, c.state).number, 1);
    account.book(VolumeCause::returned, c.state);
    EXPECT_NEAR(c.state.nodes.x[i][0], 0.4 - 0.05 * c.state.nodes.h[i], 1e-12);
    EXPECT_NEAR(c.state.nodes.v[i][0], 0, 1e-12);
    EXPECT_NEAR(c.state.nodes.v[i][1], 1, 1e-12);
    EXPECT_NEAR(c.state.ledger[VolumeCause::returned], areaOf(c.state) - moved, 1e-15);
}

}  // namespace
