// Which cell holds a point.

#include "mesh/locator.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesh/heldPoints.hpp"
#include "mesh/locate.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TEST(Locator, agreesWithTheSearchThroughAllCells) {
    const TestCase c = irregularPair();
    const auto& x = c.state.nodes.x;
    const Locator<2> locator(x, c.state.mesh.fluid.nodes);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-0.2, 1.2);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec<2> point(value(random), value(random));
        const auto exact = locate<2>(c.state.mesh.fluid, x, point, 1e-12);
        const int cell = locator.find(point);
        EXPECT_EQ(cell, exact ? exact->cell : -1);
        if (cell >= 0) ++inside;
    }
    EXPECT_GT(inside, 300);
}

TEST(Locator, emptyMeshHoldsNothing) {
    const Points<2> x;
    const std::vector<Simplex<2>> cells;
    EXPECT_FALSE(Locator<2>(x, cells).contains({0, 0}));
}

TEST(Locator, invertedCellsAreLeftOut) {
    const Points<2> x = {{0, 0}, {1, 0}, {0, 1}};
    const std::vector<Simplex<2>> inverted = {{0, 2, 1}}, upright = {{0, 1, 2}};
    EXPECT_FALSE(Locator<2>(x, inverted).contains({0.2, 0.2}));
    EXPECT_TRUE(Locator<2>(x, upright).contains({0.2, 0.2}));
}

/// Points near, far, in one plane, alone and at nodes; cells of which some have turned over.
TEST(HeldPoints, areThoseThatTheLocatorFinds) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-0.2, 1.2);
    const auto point = [&] { return Vec<3>(value(random), value(random), value(random)); };
    Points<3> x;
    for (int i = 0; i < 400; ++i) x.push_back(point());
    std::vector<Simplex<3>> cells;
    for (int i = 0; i + 4 <= 400; i += 2) cells.push_back({i, i + 1, i + 2, i + 3});
    const Locator<3> locator(x, cells);
    for (const int n : {0, 1, 7, 3000}) {
        Points<3> points;
        for (int k = 0; k < n; ++k) points.push_back(point());
        for (int k = 0; k < n / 10; ++k) points[k][2] = 0.5;
        for (int k = 0; k < n / 100; ++k) points[k] = x[k];
        if (n > 10) points[n - 1] = {50, 2, -3};
        const auto held = heldPoints<3>(x, cells, points);
        ASSERT_EQ(held.size(), points.size());
        int inside = 0;
        for (int k = 0; k < n; ++k) {
            EXPECT_EQ(held[k] != 0, locator.contains(points[k])) << n << " " << k;
            inside += held[k];
        }
        if (n == 3000) EXPECT_TRUE(inside > 500 && inside < 2900) << inside;
    }
    EXPECT_EQ(heldPoints<3>(x, {}, {point()}), std::vector<unsigned char>{0});
}

}  // namespace
