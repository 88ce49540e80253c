// Which cell holds a point.

#include "mesh/locator.hpp"

#include <gtest/gtest.h>

#include <random>

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

}  // namespace
