// What a remeshing in space changes at the surface is charged there.

#include "remesh/cavities.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "remesh/remesh.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A bipyramid over the triangle 0 1 2 with the tips 3 and 4, and far away one over 5 6 7 with 8 and 9.
struct Bipyramids {
    MovedMesh<3> moved;
    CellChanges<3> changes;
    std::vector<int> newIndex{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};

    Bipyramids() {
        for (const double to : {0.0, 10.0})
            for (const Vec<3>& x : Points<3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}, {0.3, 0.3, -2}})
                moved.x.push_back(x + Vec<3>(to, 0, 0));
        for (const int i : {0, 5}) {
            moved.fluid.push_back({i, i + 1, i + 2, i + 3});
            moved.fluid.push_back({i + 1, i, i + 2, i + 4});
        }
    }
    void fresh(Simplex<3> cell) {
        changes.fresh.push_back({VolumeCause::reshaped, cell, simplexMeasure<3>(moved.x, cell)});
    }
};

// Two tetrahedra become the three round the axis: nothing is gained. Far away one of two is lost.
TEST(Cavities, anotherDivisionOfTheSameGainsNothing) {
    Bipyramids b;
    b.changes.vanished = {0, 1, 3};
    for (const auto& edge : {std::array{0, 1}, {1, 2}, {2, 0}}) b.fresh({edge[0], edge[1], 3, 4});
    for (auto& cell : b.changes.fresh) {
        if (cell.amount > 0) continue;
        std::swap(cell.cell[0], cell.cell[1]);
        cell.amount *= -1;
    }
    const auto found = cavities<3>(b.moved, b.newIndex, b.changes);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].gain, 0, 1e-15);
    EXPECT_EQ(found[0].nodes, (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_NEAR(found[1].gain, -1.0 / 3, 1e-15);
    EXPECT_EQ(found[1].nodes, (std::vector<int>{5, 6, 7, 9}));
}

// The tip 3 has gone; nodes have other numbers now.
TEST(Cavities, nodesThatHaveGoneJoinOldCellsAlone) {
    Bipyramids b;
    b.newIndex = {8, 7, 6, -1, 5, 4, 3, 2, 1, 0};
    b.changes.vanished = {0};
    const auto found = cavities<3>(b.moved, b.newIndex, b.changes);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].gain, -1.0 / 6, 1e-15);
    EXPECT_EQ(found[0].nodes, (std::vector<int>{6, 7, 8}));
}

// Two cells that have an edge in common, but no face, are two cavities.
TEST(Cavities, hangTogetherByFaces) {
    Bipyramids b;
    b.moved.x.push_back({-1, -1, 0.5});
    b.newIndex.push_back(10);
    b.moved.fluid.push_back({0, 1, 10, 3});
    b.moved.fluid.push_back({0, 10, 1, 4});
    b.changes.vanished = {0, 5};
    EXPECT_EQ(cavities<3>(b.moved, b.newIndex, b.changes).size(), 2u);
    b.changes.vanished = {0, 1, 5};
    EXPECT_EQ(cavities<3>(b.moved, b.newIndex, b.changes).size(), 1u);
}

// A surface that is rough at one end gets other faces there: nodes at the other end have no part in it.
TEST(Cavities, whatIsReshapedStaysWhereItWas) {
    TestCase3 c = boxOfWater({2, 0.5, 0.5}, {2, 0.5, 1}, 0.1, "slip", 1e-3, 0.1);
    c.controls.remeshing.surfaceShift = 0;
    remesh<3>(c.controls.remeshing, c.kinds(), c.state);  // all cells are those of the triangulation
    auto& nodes = c.state.nodes;
    nodes.lostVolume.assign(nodes.size(), 0.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> rough(-0.02, 0.02);
    for (auto& x : nodes.x)
        if (x[2] > 0.45 && x[0] > 0.05 && x[0] < 0.55) x[2] += rough(random);
    const auto booked = [&] { return c.state.ledger[VolumeCause::reshaped]; };
    const double before = booked(), volume = cellVolume<3>(c.state);
    remesh<3>(c.controls.remeshing, c.kinds(), c.state);
    const double reshaped = booked() - before;
    EXPECT_GT(std::abs(reshaped), 1e-5);
    EXPECT_NEAR(cellVolume<3>(c.state) - volume, reshaped, 1e-15);
    double sum = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        sum += nodes.lostVolume[i];
        if (nodes.x[i][0] > 0.85) {
            EXPECT_NEAR(nodes.lostVolume[i], 0, 1e-16) << i;
        }
    }
    EXPECT_NEAR(sum, -reshaped, 1e-15);
}

}  // namespace
