// What walls leave free in space, and what they prescribe where they move: two that meet at 60 degrees.

#include <gtest/gtest.h>

#include "conditions/constraints.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

const Vec<3> velocity(0.3, 0.2, 0.1);  // of the slope

/// A tetrahedron of water whose first node lies on the edge, along y, of a floor and a moving slope.
TestCase3 inAWedge(const std::string& type) {
    TestCase3 c;
    State<3>& state = c.state;
    state.mesh.materials = {"water"};
    for (const Vec<3>& x : {Vec<3>(0, 0, 0), Vec<3>(0.8, 0, 0.4), Vec<3>(0.8, 0.5, 0.4), Vec<3>(0.9, 0.2, 0.2)}) {
        state.nodes.resize(state.nodes.size() + 1);
        state.nodes.id.back() = state.nextId++;
        state.nodes.x.back() = state.nodes.X.back() = x;
        state.nodes.h.back() = 1;
    }
    state.mesh.fluid.nodes = {{0, 1, 2, 3}};
    if (simplexMeasure<3>(state.nodes.x, state.mesh.fluid.nodes[0]) < 0) state.mesh.fluid.nodes = {{1, 0, 2, 3}};
    state.mesh.fluid.material = {0};
    const Vec<3> y(0, 1, 0), along(1, 0, 0), up(0.5, 0, std::sqrt(0.75)), inside(0.8, 0, 0.4);
    for (const auto& [name, way] : {std::pair{"floor", along}, std::pair{"slope", up}}) {
        Patch<3> patch{name, {}};
        addQuad(state, patch, {Vec<3>(-y), Vec<3>(2 * way - y), Vec<3>(2 * way + y), y}, inside);
        state.mesh.patches.push_back(patch);
    }
    c.problem.conditions = readBoundaryConditions<3>(
        Dictionary::parse("floor { type " + type + "; } slope { type slip; motion { velocity (0.3 0.2 0.1); } }",
                          "boundaryConditions"),
        state.mesh.patches);
    separateFromWalls<3>({true, true}, state);
    return c;
}

TEST(Freedom, edgeOfAMovingSlope) {
    const TestCase3 c = inAWedge("slip");
    ASSERT_EQ(nSupports(c.state.nodes.wall[0]), 2);
    const double dt = 0.1;
    const auto constraints = nodeConstraints<3>(c.state.mesh, c.problem.conditions, c.topology(), c.state.nodes, 0, dt);
    const Vec<3> n(0, 0, 1), m(std::sqrt(0.75), 0, -0.5), u(1, 2, 3), zero = Vec<3>::Zero();
    EXPECT_EQ(constraints.freedom[0].count, 1);
    EXPECT_LT((constraints.project(0, u) - Vec<3>(0, 2, 0)).norm(), 1e-12);
    const Vec<3> v = constraints.velocity(0, zero, u), x = constraints.position(0, zero, dt * u);
    for (const Vec<3>& moved : {v, Vec<3>(x / dt)}) {
        EXPECT_NEAR(n.dot(moved), 0, 1e-12);
        EXPECT_NEAR(m.dot(moved), m.dot(velocity), 1e-12);
        EXPECT_NEAR(moved[1], 2, 1e-12);
    }
}

TEST(Freedom, nodesOfOneWallAreFreeInItsPlane) {
    TestCase3 c = inAWedge("slip");
    c.state.nodes.x[0] = {0.5, 0, 0};
    c.state.nodes.wall[0][1] = -1;
    const auto constraints =
        nodeConstraints<3>(c.state.mesh, c.problem.conditions, c.topology(), c.state.nodes, 0, 0.1);
    EXPECT_EQ(constraints.freedom[0].count, 2);
    EXPECT_LT((constraints.velocity(0, c.state.nodes.x[0], {1, 2, 3}) - Vec<3>(1, 2, 0)).norm(), 1e-12);
}

}  // namespace
