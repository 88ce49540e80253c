// What walls and patches let the nodes do.

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TestCase tank(const std::string& words) {
    return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                        " } ); walls ( floor { points ((0 0) (1 0)); } sides { points ((1 0) (1 1)); } );",
                    water, words);
}

TEST(NodeConstraints, nodesSlideAlongSlipWalls) {
    const TestCase c = tank("floor { type slip; } sides { type slip; }");
    const auto constraints = c.constraints(c.topology());
    const auto at = [&](double x, double y) { return nearestNode(c.state.nodes.x, {x, y}); };
    const int floor = at(0.5, 0), side = at(1, 0.2), corner = at(1, 0), inside = at(0.5, 0.3);
    EXPECT_LT((constraints.project(floor, {3, 4}) - Vec<2>(3, 0)).norm(), 1e-12);
    EXPECT_LT((constraints.project(side, {3, 4}) - Vec<2>(0, 4)).norm(), 1e-12);
    EXPECT_EQ(constraints.project(corner, {3, 4}).norm(), 0);
    EXPECT_EQ(constraints.project(inside, {3, 4}), Vec<2>(3, 4));
}

TEST(NodeConstraints, nodesStickToNoSlipWalls) {
    const TestCase c = tank("floor { type noSlip; } sides { type noSlip; }");
    const auto constraints = c.constraints(c.topology());
    const auto at = [&](double x, double y) { return nearestNode(c.state.nodes.x, {x, y}); };
    EXPECT_EQ(constraints.hold[at(0.5, 0)], Hold::fixed);
    EXPECT_EQ(constraints.hold[at(1, 0.2)], Hold::fixed);
    EXPECT_EQ(constraints.hold[at(1, 0.5)], Hold::slide);  // the contact line could not move otherwise
}

TEST(NodeConstraints, symmetrySlidesAndCornersHold) {
    const TestCase c = makeCase("meshSize 0.1; bodies ( block { type solid; material rubber; " +
                                    rectangle(0, 0, 1, 0.5) + " patches { sides { edges ((0 1) (1 2)); } } } );",
                                rubber, "sides { type symmetry; }");
    const auto constraints = c.constraints(c.topology());
    const int floor = nearestNode(c.state.nodes.x, {0.5, 0}), side = nearestNode(c.state.nodes.x, {1, 0.2});
    EXPECT_EQ(constraints.hold[floor], Hold::slide);
    EXPECT_LT((constraints.project(floor, {3, 4}) - Vec<2>(3, 0)).norm(), 1e-12);
    EXPECT_LT((constraints.project(side, {3, 4}) - Vec<2>(0, 4)).norm(), 1e-12);
    EXPECT_EQ(constraints.hold[nearestNode(c.state.nodes.x, {1, 0})], Hold::fixed);
    EXPECT_EQ(constraints.hold[nearestNode(c.state.nodes.x, {1, 0.5})], Hold::slide);
}

TEST(BoundaryConditions, everyPatchNeedsAKnownCondition) {
    EXPECT_THROW(tank("floor { type slip; }"), UserError);
    EXPECT_THROW(tank("floor { type slip; } sides { type slipp; }"), UserError);
    EXPECT_THROW(tank("floor { type slip; } sides { type slip; } roof { type slip; }"), UserError);
}

}  // namespace
