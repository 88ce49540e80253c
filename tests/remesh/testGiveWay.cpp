// The free surface gives way to what was lost or gained around its nodes.

#include "remesh/surfaceShift.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "remesh/handOn.hpp"
#include "remesh/lostVolume.hpp"
#include "state/images.hpp"
#include "support/cases.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Water with an uneven surface in a tank; `free`: a node in the middle of the surface.
struct Tank {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                          water, "tank { type slip; }");
    Topology<2> topology = c.topology();
    const double h = 0.1;

    Tank() {
        for (auto& x : c.state.nodes.x)
            if (x[1] > 0.49) x[1] += 0.03 * std::sin(7 * x[0]);
        topology = c.topology();
    }
    double area() const { return cellVolume<2>(c.state.nodes.x, c.state.mesh.fluid.nodes); }
    int surfaceNode(double x) const {
        for (int i = 0; i < c.state.nodes.size(); ++i)
            if (topology.freeSurface[i] && std::abs(c.state.nodes.x[i][0] - x) < 1e-6) return i;
        throw std::runtime_error("no such node");
    }
    void shift() {
        shiftSurface<2>(c.controls.remeshing, topology, std::vector<double>(c.state.nodes.id.size(), 0.0), 1, c.state);
    }
};

// Half by the node, a quarter by each of its neighbours along the surface.
TEST(GiveWay, aNodeBringsWhatItLacks) {
    for (const double lost : {2e-4, -2e-4}) {
        Tank t;
        const int i = t.surfaceNode(0.5);
        const double before = t.area();
        const Points<2> x = t.c.state.nodes.x;
        t.c.state.nodes.lostVolume[i] = lost;
        t.shift();
        EXPECT_NEAR(t.area() - before, lost, 5e-3 * std::abs(lost));  // linear but for what neighbours have in common
        int moved = 0;
        for (int j = 0; j < t.c.state.nodes.size(); ++j) {
            const double step = (t.c.state.nodes.x[j] - x[j]).norm();
            if (step == 0) continue;
            ++moved;
            EXPECT_EQ(t.c.state.nodes.x[j][1] > x[j][1], lost > 0);
            EXPECT_NEAR(step, std::abs(lost) / t.h * (j == i ? 0.5 : 0.25), 0.05 * std::abs(lost) / t.h);
        }
        EXPECT_EQ(moved, 3);
        chargeMotion<2>(t.topology.fluid, t.c.state.mesh.fluid.nodes, x, t.c.state.nodes);
        double left = 0;
        for (double amount : t.c.state.nodes.lostVolume) left += amount;
        EXPECT_NEAR(left, 0, 5e-3 * std::abs(lost));
    }
}

// It would hardly change the volume of patches, and grow: a falling jet of syrup got spikes.
TEST(GiveWay, noZigZag) {
    Tank t;
    const Points<2> x = t.c.state.nodes.x;
    for (int k = 1; k < 10; ++k) t.c.state.nodes.lostVolume[t.surfaceNode(0.1 * k)] = k % 2 == 0 ? 1e-4 : -1e-4;
    t.shift();
    for (int k = 2; k < 9; ++k) {
        const int i = t.surfaceNode(0.1 * k);
        EXPECT_NEAR((t.c.state.nodes.x[i] - x[i]).norm(), 0, 1e-15);
    }
}

TEST(GiveWay, noFartherThanTheLimit) {
    Tank t;
    const int i = t.surfaceNode(0.5);
    const Vec<2> x = t.c.state.nodes.x[i];
    t.c.state.nodes.lostVolume[i] = 1;
    t.shift();
    EXPECT_NEAR((t.c.state.nodes.x[i] - x).norm(), t.c.controls.remeshing.surfaceShift * t.h, 1e-15);
}

TEST(GiveWay, alongTheWallAtTheContactLine) {
    Tank t;
    const int i = t.surfaceNode(0);
    ASSERT_TRUE(isSupported(t.c.state.nodes.wall[i]));
    const double before = t.area();
    const Vec<2> x = t.c.state.nodes.x[i];
    t.c.state.nodes.lostVolume[i] = 1e-4;
    t.shift();
    EXPECT_EQ(t.c.state.nodes.x[i][0], 0);
    EXPECT_GT(t.c.state.nodes.x[i][1], x[1]);
    EXPECT_NEAR(t.area() - before, 1e-4, 1e-5);  // a quarter goes to the neighbour, whose area is tilted
}

TEST(GiveWay, nothingInsideAtWallsOrInDrops) {
    Tank t;
    const Points<2> x = t.c.state.nodes.x;
    for (int i = 0; i < t.c.state.nodes.size(); ++i)
        if (!t.topology.freeSurface[i]) t.c.state.nodes.lostVolume[i] = 1e-3;
    t.shift();
    EXPECT_EQ(t.c.state.nodes.x, x);
    t.c.controls.remeshing.surfaceShift = 0;
    t.c.state.nodes.lostVolume.assign(t.c.state.nodes.id.size(), 1e-3);
    t.shift();
    EXPECT_EQ(t.c.state.nodes.x, x);
}

TEST(GiveWay, noCellLosesMoreThanHalf) {
    Tank t;
    const int i = t.surfaceNode(0.5);
    for (int s = t.topology.fluid.start[i]; s < t.topology.fluid.start[i + 1]; ++s) {
        const auto& cell = t.c.state.mesh.fluid.nodes[t.topology.fluid.cell[s]];
        if (std::count_if(cell.begin(), cell.end(), [&](int node) { return t.topology.freeSurface[node]; }) > 1)
            continue;
        for (int node : cell)  // a flat cell under the surface
            if (node != i) t.c.state.nodes.x[node][1] = t.c.state.nodes.x[i][1] - 0.004;
    }
    const Points<2> x = t.c.state.nodes.x;
    t.c.state.nodes.lostVolume[i] = -1;
    t.shift();
    for (const auto& s : t.c.state.mesh.fluid.nodes)
        if (simplexMeasure<2>(x, s) > 0) {
            EXPECT_GE(simplexMeasure<2>(t.c.state.nodes.x, s), 0.5 * simplexMeasure<2>(x, s));
        }
    EXPECT_EQ(t.c.state.nodes.x[i], x[i]);
}

/// The surface sinks wherever it can, by up to `limit` h; the cells' measures before and after.
std::vector<std::array<double, 2>> sink(Tank& t, double limit) {
    const Points<2> x = t.c.state.nodes.x;
    t.c.controls.remeshing.surfaceShift = limit;
    for (int i = 0; i < t.c.state.nodes.size(); ++i)
        if (t.topology.freeSurface[i]) t.c.state.nodes.lostVolume[i] = -1;
    t.shift();
    std::vector<std::array<double, 2>> measures;
    for (const auto& s : t.c.state.mesh.fluid.nodes)
        measures.push_back({simplexMeasure<2>(x, s), simplexMeasure<2>(t.c.state.nodes.x, s)});
    return measures;
}

// The large ones, which would be no small ones afterwards.
TEST(GiveWay, largeCellsKeepHalf) {
    Tank t;
    double least = 1;
    for (const auto& [before, after] : sink(t, 0.4)) {
        ASSERT_GT(before, 0.2 * t.h * t.h);
        EXPECT_GE(after, 0.5 * before);
        least = std::min(least, after / before);
    }
    EXPECT_LT(least, 0.7) << "hardly anything has moved";
}

// A cell that would lose a fifth alone, but be below a tenth of h^2 then.
TEST(GiveWay, noCellBecomesSmall) {
    for (const double depth : {0.24, 0.3}) {  // of the cells under the node, in h: 0.12 and 0.15 h^2
        Tank t;
        Points<2>& x = t.c.state.nodes.x;
        const int i = t.surfaceNode(0.5);
        for (int j = 0; j < t.c.state.nodes.size(); ++j)
            if (t.topology.freeSurface[j]) x[j][1] = 0.5;
        const auto& ring = t.topology.ring;
        for (int s = ring.start[i]; s < ring.start[i + 1]; ++s)
            if (!t.topology.freeSurface[ring.node[s]]) x[ring.node[s]][1] = 0.5 - depth * t.h;
        for (const auto& [before, after] : sink(t, 0.05)) {
            EXPECT_GT(after, 0.5 * before) << "a matter of the other rule";
            EXPECT_GE(after, std::min(before, 0.1 * t.h * t.h));
        }
        EXPECT_NEAR(x[i][1], depth < 0.25 ? 0.5 : 0.5 - 0.05 * t.h, 1e-15);
    }
}

// In space a node that may not move so far, or cannot, is helped by those around it in the same step.
TEST(GiveWay, neighboursBringWhatANodeCannot) {
    constexpr double h = 0.1;
    for (const bool stuck : {false, true}) {
        TestCase3 c = boxOfWater({1.2, 0.8, 0.3}, {1.2, 0.8, 0.6}, h, "slip", 1e-3, 0.1);
        auto& nodes = c.state.nodes;
        nodes.lostVolume.assign(nodes.size(), 0.0);
        const Vec<3> place(0.6, 0.4, 0.3);
        const auto nearest = [&](const Vec<3>& to) {
            const auto at = std::min_element(nodes.x.begin(), nodes.x.end(), [&](const auto& a, const auto& b) {
                return (a - to).squaredNorm() < (b - to).squaredNorm();
            });
            return static_cast<int>(at - nodes.x.begin());
        };
        const int i = nearest(place);
        if (stuck) nodes.x[nearest(place - Vec<3>(0, 0, h))] = place - Vec<3>(0, 0, 0.01 * h);  // flat cells below it
        const auto topology = c.topology();
        const double limit = c.controls.remeshing.surfaceShift * h;
        const double gained = 4 * limit * h * h;  // four times what the node itself may bring
        nodes.lostVolume[i] = -gained;
        const Points<3> x = nodes.x;
        const double before = cellVolume<3>(c.state);
        shiftSurface<3>(c.controls.remeshing, topology, std::vector<double>(nodes.size(), 0.0), 1, c.state);
        EXPECT_NEAR(cellVolume<3>(c.state) - before, -gained, 0.03 * gained) << stuck;
        EXPECT_NEAR(std::accumulate(nodes.lostVolume.begin(), nodes.lostVolume.end(), 0.0), -gained, 1e-12 * gained);
        for (int j = 0; j < nodes.size(); ++j) EXPECT_LE((nodes.x[j] - x[j]).norm(), limit * (1 + 1e-9)) << j;
        EXPECT_EQ(nodes.x[i] == x[i], stuck);
        for (const auto& cell : c.state.mesh.fluid.nodes) {
            const double was = simplexMeasure<3>(x, cell);
            EXPECT_GE(simplexMeasure<3>(nodes.x, cell), std::min(0.5 * was, was));
        }
    }
}

// A node beside a periodic side hands on to the one beyond the other side, by its image.
TEST(GiveWay, handsOnThroughPeriodicSides) {
    State<2> state;
    state.nodes.resize(5);
    state.nodes.id = {0, 1, 2, firstImage + 2, 2 * firstImage};  // the last two: images of 2 and 0
    Topology<2> topology;
    topology.ring.start = {0, 2, 4, 6, 6, 6};
    topology.ring.node = {1, 3, 0, 2, 1, 4};
    std::vector<double> amounts{-3, 0, 1, 0, 0};
    handOn<2>(topology, state, {0.5, 0, 4, 0, 0}, amounts);
    EXPECT_EQ(amounts, (std::vector<double>{-0.5, 0, -1.5, -1.5, -0.5}));
}

}  // namespace
