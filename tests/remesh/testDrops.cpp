// Drops in free flight: long steps end where they strike a wall, what has left for good goes, and its volume
// is known.

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "remesh/letGo.hpp"
#include "remesh/remesh.hpp"
#include "support/cases.hpp"
#include "walls/landing.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double volume = 1e-4;

/// Water at rest in a tank, 1 m wide and high, half full.
TestCase tank(const std::string& kind = "slip") {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                          water, "tank { type " + kind + "; }");
    c.start(1e-3);
    return c;
}

int addDrop(State<2>& state, const Vec<2>& x, const Vec<2>& v) {
    auto& nodes = state.nodes;
    nodes.append(nodes, nearestNode(nodes.x, {0.5, 0.5}));
    nodes.id.back() = state.nextId++;
    nodes.x.back() = x;
    nodes.v.back() = v;
    nodes.a.back() = {0, -9.81};
    nodes.p.back() = nodes.lostVolume.back() = 0;
    nodes.dropVolume.back() = volume;
    nodes.wall.back() = unsupported<2>();
    return nodes.size() - 1;
}

TEST(Drops, landWhereTheirWayCrossesAWall) {
    TestCase c = tank();
    const int side = addDrop(c.state, {0.9, 0.8}, {40, -40}), floor = addDrop(c.state, {0.8, 0.6}, {5, -70}),
              past = addDrop(c.state, {0.9, 0.9}, {10, 60});
    const auto topology = c.topology();
    const Points<2> old = c.state.nodes.x;
    auto& x = c.state.nodes.x;
    x[side] += Vec<2>(0.4, -0.4);
    x[floor] += Vec<2>(0.1, -1.2);
    x[past] += Vec<2>(0.2, 1.2);  // over the end of the wall
    landOnWalls<2>(c.controls.remeshing.expert.walls, topology, old, 9.81, c.state);
    EXPECT_LT((x[side] - Vec<2>(1, 0.7)).norm(), 1e-12);
    EXPECT_LT((x[floor] - Vec<2>(0.85, 0)).norm(), 1e-12);
    EXPECT_LT((x[past] - Vec<2>(1.1, 2.1)).norm(), 1e-12);
    EXPECT_TRUE(isSupported(c.state.nodes.wall[side]));
    EXPECT_TRUE(isSupported(c.state.nodes.wall[floor]));
    EXPECT_FALSE(isSupported(c.state.nodes.wall[past]));
    EXPECT_LT((c.state.nodes.v[side] - Vec<2>(0, -40)).norm(), 1e-12);
}

// A drop that flies eight triangles far in one step, into a wall: nothing is rejected.
TEST(Drops, aStepOfManyTriangles) {
    for (const std::string kind : {"slip", "noSlip"}) {
        TestCase c = tank(kind);
        const Id id = c.state.nodes.id[addDrop(c.state, {0.3, 0.9}, {80, 0})];
        EXPECT_EQ(c.step(0.01).rejected, 0);
        const int drop = nodeOf(c.state.nodes, id);
        ASSERT_GE(drop, 0);
        EXPECT_NEAR(c.state.nodes.x[drop][0], 1, 1e-12);
        EXPECT_NEAR(c.state.nodes.x[drop][1], 0.9, 1e-3);
        EXPECT_TRUE(isSupported(c.state.nodes.wall[drop]));
    }
}

// Over water at rest a fast drop asks for its own steps only when it comes near, and then it joins the water.
TEST(Drops, areSeenBeforeTheyStrike) {
    for (const double x : {0.55, 0.501}) {  // between two nodes of the surface, and on one: its own node there goes
        TestCase c = tank();
        const Id id = c.state.nodes.id[addDrop(c.state, {x, 0.95}, {0, -20})];
        const auto flies = [&] {
            const int drop = nodeOf(c.state.nodes, id);
            return drop >= 0 && !c.topology().wet(drop);
        };
        int steps = 0, rejected = 0;
        for (; steps < 40 && flies(); ++steps) {
            const auto rate = courantRate<2>(c.state);
            rejected += c.step(std::min({0.01, 0.8 / rate.largest, 0.7 / (rate.compression + 1e-300)})).rejected;
        }
        EXPECT_LT(steps, 15) << x;
        EXPECT_EQ(rejected, 0) << x;
        EXPECT_NEAR(dropVolume<2>(c.state), 0, 1e-16) << x;
        EXPECT_LE(largest(c.state.nodes.v), 20.5) << x;
    }
}

// Nearer than a quarter of h to a node that it approaches, a drop is part of it, with its momentum and its
// volume.
TEST(Drops, joinWhatTheyMeet) {
    for (const double speed : {-3.0, 3.0}) {
        TestCase c = tank();
        const int node = nearestNode(c.state.nodes.x, {0.5, 0.5});
        const Id water = c.state.nodes.id[node], drop = c.state.nodes.id[addDrop(c.state, {0.51, 0.51}, {1, speed})];
        double patch = 0, before = totalVolume<2>(c.state);
        for (const auto& s : c.state.mesh.fluid.nodes)
            if (std::find(s.begin(), s.end(), node) != s.end()) patch += simplexMeasure<2>(c.state.nodes.x, s) / 3;
        for (double lost : c.state.nodes.lostVolume) before += lost;
        const Vec<2> v = c.state.nodes.v[node];
        remesh<2>(c.controls.remeshing, c.kinds(), c.state);
        const bool joins = speed < 0;
        EXPECT_EQ(nodeOf(c.state.nodes, drop) < 0, joins);
        const int now = nodeOf(c.state.nodes, water);
        const Vec<2> common = (patch * v + volume * Vec<2>(1, speed)) / (patch + volume);
        EXPECT_LT((c.state.nodes.v[now] - (joins ? common : v)).norm(), 1e-12);
        if (joins) {
            EXPECT_GT(c.state.nodes.lostVolume[now], 0.5 * volume);
        }
        double after = totalVolume<2>(c.state);
        for (double lost : c.state.nodes.lostVolume) after += lost;
        EXPECT_NEAR(after, before, 1e-14);
    }
}

// Between surfaces that close on them: what they carry goes to the nearest open water; without any it is gone.
TEST(Drops, areSqueezedOut) {
    for (const bool anyWater : {true, false}) {
        TestCase c = tank();
        const int drop = addDrop(c.state, {0.98, 0.62}, {0, 0});
        const Id squeezed = c.state.nodes.id[drop];
        if (!anyWater) c.state.mesh.fluid = {};
        double before = totalVolume<2>(c.state);
        for (const double lost : c.state.nodes.lostVolume) before += lost;
        Triangulator<2> triangulator;
        remesh<2>({c.controls.remeshing, c.kinds(), c.topology(), 1e-3, {}, {drop}}, triangulator, c.state);
        EXPECT_EQ(nodeOf(c.state.nodes, squeezed), -1);
        EXPECT_NEAR(c.state.ledger[VolumeCause::gone], anyWater ? 0 : -volume, 1e-16);
        if (!anyWater) continue;
        const int heir = nearestNode(c.state.nodes.x, {0.9, 0.5});  // that at x = 1 is on the wall
        EXPECT_NEAR(c.state.nodes.lostVolume[heir], volume, 1e-12);
        double after = totalVolume<2>(c.state);
        for (const double lost : c.state.nodes.lostVolume) after += lost;
        EXPECT_NEAR(after, before, 1e-14);
    }
}

// The nearest node has to go, too: another one gets all that the drop carries.
TEST(Drops, areNotSqueezedIntoWhatGoes) {
    std::map<Id, double> lost[2];
    for (const bool both : {true, false}) {
        TestCase c = tank();
        const int drop = addDrop(c.state, {0.98, 0.62}, {0, 0}), near = nearestNode(c.state.nodes.x, {0.9, 0.5});
        std::vector<int> pinched{near};
        if (both) pinched.push_back(drop);
        Triangulator<2> triangulator;
        remesh<2>({c.controls.remeshing, c.kinds(), c.topology(), 1e-3, {}, pinched}, triangulator, c.state);
        for (int i = 0; i < c.state.nodes.size(); ++i) lost[both][c.state.nodes.id[i]] = c.state.nodes.lostVolume[i];
    }
    double most = 0;
    for (const auto& [id, one] : lost[true]) most = std::max(most, one - lost[false][id]);
    EXPECT_NEAR(most, volume, 1e-12);
}

TEST(Drops, whatIsGoneIsGone) {
    const auto isGone = [](const Vec<2>& x, const Vec<2>& v, bool moving = false) {
        TestCase c = tank();
        const int drop = addDrop(c.state, x, v);
        const auto gone = goneForGood<2>(c.topology(), c.problem.gravity, moving, c.state);
        EXPECT_TRUE(gone.empty() || gone == std::vector<int>{drop});
        return !gone.empty();
    };
    EXPECT_TRUE(isGone({0.5, -0.3}, {0, -1}));   // below
    EXPECT_TRUE(isGone({-0.3, 0.5}, {-1, 5}));   // beside, away
    EXPECT_TRUE(isGone({1.3, 0.5}, {0, 3}));     // beside, straight up
    EXPECT_FALSE(isGone({1.3, 0.5}, {-1, 3}));   // comes back
    EXPECT_FALSE(isGone({0.5, 1.3}, {0, 50}));   // above
    EXPECT_FALSE(isGone({1.1, -0.1}, {1, -1}));  // near
    EXPECT_FALSE(isGone({0.5, 0.9}, {0, -1}));   // inside
    EXPECT_FALSE(isGone({0.5, -0.3}, {0, -1}, true));
    EXPECT_TRUE(isGone({0.5, -1.5}, {0, -1}, true));

    TestCase c = tank();  // water that falls faster would catch up with it
    addDrop(c.state, {0.5, -0.3}, {0, -1});
    c.state.nodes.v[nearestNode(c.state.nodes.x, {0.5, 0.2})] = {0, -2};
    EXPECT_TRUE(goneForGood<2>(c.topology(), c.problem.gravity, false, c.state).empty());
}

TEST(Drops, whatGoesIsInTheLedger) {
    for (const bool letGo : {true, false}) {
        TestCase c = tank();
        c.controls.remeshing.letGo = letGo;
        const Id stays = c.state.nodes.id[addDrop(c.state, {0.3, 0.8}, {0, 0})],
                 goes = c.state.nodes.id[addDrop(c.state, {0.5, -0.3}, {0, -1})];
        const double before = totalVolume<2>(c.state), sum = c.ledgerSum();
        const double lost = std::accumulate(c.state.nodes.lostVolume.begin(), c.state.nodes.lostVolume.end(), 0.0);
        c.state.ledger.countFields(c.state.nodes.size());
        const auto ledger = c.state.ledger;
        c.step(1e-3);
        EXPECT_GE(nodeOf(c.state.nodes, stays), 0);
        EXPECT_EQ(nodeOf(c.state.nodes, goes) < 0, letGo);
        EXPECT_EQ(c.state.ledger.has(VolumeCause::gone), letGo);
        EXPECT_NEAR(c.state.ledger[VolumeCause::gone], letGo ? -volume : 0, 1e-16);
        EXPECT_NEAR(totalVolume<2>(c.state) - before, c.ledgerSum() - sum, 1e-14);
        // what nodes lack, cells, drops and what has gone: all that there was
        const auto& now = c.state.nodes.lostVolume;
        EXPECT_NEAR(
            totalVolume<2>(c.state) + std::accumulate(now.begin(), now.end(), 0.0) - c.state.ledger[VolumeCause::gone],
            before + lost, 1e-14);
        for (const auto& [cause, amounts] : c.state.ledger.fields())
            EXPECT_NEAR(std::accumulate(amounts.begin(), amounts.end(), 0.0), c.state.ledger[cause] - ledger[cause],
                        1e-14)
                << textOf(cause).name;
        EXPECT_EQ(c.state.ledger.fields().count(VolumeCause::gone), letGo ? 1u : 0u);
        c.state.ledger.countFields(c.state.nodes.size());
        for (const auto& [cause, amounts] : c.state.ledger.fields())
            EXPECT_EQ(amounts, std::vector<double>(c.state.nodes.id.size(), 0.0)) << textOf(cause).name;
    }
}

// A gravity that may turn round may bring it back.
TEST(Drops, comeBackWithGravity) {
    for (const std::string value : {"(0 -9.81 0)", "table ((0 (0 -9.81 0)) (1 (0 9.81 0)))"}) {
        TestCase c = tank();
        c.problem.gravityOverTime =
            readFunction1<Eigen::Vector3d>(Dictionary::parse("value " + value + ";", "g"), "value");
        const Id id = c.state.nodes.id[addDrop(c.state, {0.5, -0.3}, {0, -1})];
        c.step(1e-3);
        EXPECT_EQ(nodeOf(c.state.nodes, id) < 0, value[0] == '(') << value;
    }
}

}  // namespace
