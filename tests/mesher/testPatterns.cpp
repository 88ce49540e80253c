// Structured bodies: exact counts and connectivity.

#include "cases.hpp"

namespace pfem::testing {
namespace {

State<2> patterned(const std::string& pattern, const std::string& vertices = "(0 0) (3 0) (3 2) (0 2)") {
    return meshOf(dictOf(solidBody("block", vertices, "pattern " + pattern + "; cells (6 4);"))).state;
}

/// Triangles around each node, as node count per number of triangles.
std::map<int, int> valences(const State<2>& state) {
    std::vector<int> count(state.nodes.size(), 0);
    for (const auto& t : state.mesh.solid.nodes)
        for (const int i : t) ++count[i];
    std::map<int, int> histogram;
    for (const int n : count) ++histogram[n];
    return histogram;
}

TEST(Patterns, oneWay) {
    const auto state = patterned("oneWay");
    EXPECT_EQ(state.nodes.size(), 35);
    EXPECT_EQ(state.mesh.solid.size(), 48);
    // 15 inner nodes with 6; on sides 3; two corners with 2, two with 1
    EXPECT_EQ(valences(state), (std::map<int, int>{{1, 2}, {2, 2}, {3, 16}, {6, 15}}));
    expectSound(state);
}

TEST(Patterns, checkerboard) {
    const auto state = patterned("checkerboard");
    EXPECT_EQ(state.nodes.size(), 35);
    EXPECT_EQ(state.mesh.solid.size(), 48);
    // inner nodes have 8 or 4 in turn, side nodes 4 or 2
    EXPECT_EQ(valences(state), (std::map<int, int>{{2, 14}, {4, 13}, {8, 8}}));
    expectSound(state);
}

TEST(Patterns, crossed) {
    const auto state = patterned("crossed");
    EXPECT_EQ(state.nodes.size(), 35 + 24);
    EXPECT_EQ(state.mesh.solid.size(), 96);
    EXPECT_EQ(valences(state), (std::map<int, int>{{2, 4}, {4, 16 + 24}, {8, 15}}));
    expectSound(state);
}

TEST(Patterns, cellsFromMeshSize) {
    const auto state =
        meshOf(dictOf(solidBody("block", "(0 0) (3 0) (3 2) (0 2)", "pattern oneWay; meshSize 0.25;"))).state;
    EXPECT_EQ(state.mesh.solid.size(), 2 * 12 * 8);
}

TEST(Patterns, nodesOfARectangleAreExact) {
    const auto state = patterned("crossed");
    for (const auto& x : state.nodes.x) {
        EXPECT_NEAR(4 * x.x(), std::round(4 * x.x()), 1e-13);
        EXPECT_NEAR(4 * x.y(), std::round(4 * x.y()), 1e-13);
    }
}

TEST(Patterns, followsCurvedSides) {
    // quarter ring, radii 1 and 2
    const auto text = dictOf(solidBody("ring", "(1 0) (2 0) (0 2) (0 1)",
                                       "pattern oneWay; cells (4 8); "
                                       "edges (arc 1 2 (1.4142135623730951 1.4142135623730951) "
                                       "arc 3 0 (0.7071067811865476 0.7071067811865476));"));
    const auto state = meshOf(text).state;
    expectSound(state);
    for (const auto& x : state.nodes.x) {
        const double r = 4 * x.norm();
        EXPECT_NEAR(r, std::round(r), 1e-12);  // transfinite interpolation keeps the circles
    }
}

TEST(Patterns, unstructuredNeighbourConforms) {
    const auto state = meshOf(dictOf(solidBody("block", "(0 0) (1 0) (1 1) (0 1)", "pattern crossed; cells (7 7);") +
                                     fluidBody("water", "(0 1) (1 1) (1 2) (0 2)")))
                           .state;
    expectSound(state);
}

TEST(Patterns, vertexBetweenNodesIsRefused) {
    const auto text = dictOf(solidBody("block", "(0 0) (1 0) (1 1) (0 1)", "pattern crossed; cells (4 4);") +
                             fluidBody("water", "(0.3 1) (0.8 1) (0.8 2) (0.3 2)"));
    EXPECT_THROW(meshOf(text), UserError);
}

}  // namespace
}  // namespace pfem::testing
