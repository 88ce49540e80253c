// Bodies and walls that touch share their nodes.

#include "cases.hpp"

namespace pfem::testing {
namespace {

TEST(Conformity, standardCasesAreSound) {
    for (const auto& text : {damBreakElasticWall(), elasticContainer(), hydrostaticPlate(), cylinder()})
        expectSound(meshOf(text).state);
}

/// Edges with a fluid cell on one side and a solid one on the other.
double interfaceLength(const State<2>& state) {
    const auto solid = directedEdges(state.mesh.solid);
    double length = 0;
    for (const auto& [edge, n] : directedEdges(state.mesh.fluid))
        if (solid.count({edge[1], edge[0]})) length += (state.nodes.x[edge[0]] - state.nodes.x[edge[1]]).norm();
    return length;
}

TEST(Conformity, interfaceIsComplete) {
    EXPECT_NEAR(interfaceLength(meshOf(hydrostaticPlate()).state), 1.0, 1e-12);
    EXPECT_NEAR(interfaceLength(meshOf(cylinder()).state), 0.2 * 3.14159265, 1e-3);
    EXPECT_EQ(interfaceLength(meshOf(damBreakElasticWall()).state), 0);
}

TEST(Conformity, interfaceTakesTheSmallerSize) {
    const auto state = meshOf(hydrostaticPlate()).state;
    const auto solid = directedEdges(state.mesh.solid);
    for (const auto& [edge, n] : directedEdges(state.mesh.fluid))
        if (solid.count({edge[1], edge[0]})) {
            EXPECT_NEAR((state.nodes.x[edge[0]] - state.nodes.x[edge[1]]).norm(), 0.0125, 1e-9);
        }
}

TEST(Conformity, commonLineWithOtherVertices) {
    // the edge x = 1 is cut differently by three bodies and by a wall's end
    const auto state = meshOf(dictOf(fluidBody("a", "(0 0) (1 0) (1 0.37) (1 1) (0 1)") +
                                         solidBody("b", "(1 0.2) (2 0.2) (2 0.55) (1 0.55)") +
                                         solidBody("c", "(1 0.55) (2 0.55) (2 1.3) (1 1.3)"),
                                     "w { points ((1 0.1) (1 0.2)); }"))
                           .state;
    expectSound(state);
    EXPECT_NEAR(interfaceLength(state), 0.8, 1e-12);
}

TEST(Conformity, noWallUnderTheSolid) {
    const auto state = meshOf(damBreakElasticWall()).state;
    EXPECT_NEAR(lengthOf(state, "tank"), 0.6 + 0.596 + 0.6 - 0.012, 1e-12);
    EXPECT_NEAR(lengthOf(state, "wallBase"), 0.012, 1e-14);
    // the walls' chains end at the solid's corners, with points of their own
    std::map<int, int> ends;
    for (const auto& [a, b] : patchOf(state, "tank").faces) ++ends[a], --ends[b];
    std::set<double> free;
    for (const auto& [node, n] : ends) {
        if (n != 0) free.insert(state.nodes.x[node].x());
        for (const auto& cell : state.mesh.solid.nodes)
            EXPECT_TRUE(std::find(cell.begin(), cell.end(), node) == cell.end());
    }
    std::set<double> wanted{0, 0.596};
    for (const auto& face : patchOf(state, "wallBase").faces)
        for (const int node : face)
            if (std::abs(state.nodes.x[node].x() - 0.298) > 0.0059) wanted.insert(state.nodes.x[node].x());
    EXPECT_EQ(free, wanted);
}

// A wall has a face per straight piece: left wall, floor before and behind the elastic wall, right wall.
TEST(Conformity, wallsAreStraightFacesBetweenCorners) {
    const auto state = meshOf(damBreakElasticWall()).state;
    const auto& faces = patchOf(state, "tank").faces;
    ASSERT_EQ(faces.size(), 4u);
    std::vector<double> lengths;
    for (const auto& face : faces) lengths.push_back((state.nodes.x[face[0]] - state.nodes.x[face[1]]).norm());
    std::sort(lengths.begin(), lengths.end());
    const double expected[] = {0.292, 0.292, 0.6, 0.6};
    for (int f = 0; f < 4; ++f) EXPECT_NEAR(lengths[f], expected[f], 1e-12);
}

// The fluid's edges along a wall run as the wall's face does, and its nodes know the face they slide along.
TEST(Conformity, fluidIsOnTheLeftOfItsWall) {
    const auto state = meshOf(damBreakElasticWall()).state;
    const auto& faces = patchOf(state, "tank").faces;
    int first = 0;
    for (const auto& patch : state.mesh.patches) {
        if (patch.name == "tank") break;
        first += static_cast<int>(patch.faces.size());
    }
    const auto liesOn = [&](int node, int f) {
        const auto& own = state.nodes.wall[node];
        return std::find(own.begin(), own.end(), first + f) != own.end();
    };
    double wet = 0;
    for (const auto& [edge, count] : directedEdges(state.mesh.fluid))
        for (int f = 0; f < 4; ++f) {
            if (!liesOn(edge[0], f) || !liesOn(edge[1], f)) continue;
            const Vec<2> along = state.nodes.x[faces[f][1]] - state.nodes.x[faces[f][0]];
            const Vec<2> t = state.nodes.x[edge[1]] - state.nodes.x[edge[0]];
            EXPECT_NEAR(t.dot(along), t.norm() * along.norm(), 1e-12);
            wet += t.norm();
        }
    EXPECT_NEAR(wet, 0.146 + 0.292, 1e-12);
}

TEST(Conformity, bodyPatchesHaveTheBodyOnTheLeft) {
    const auto state = meshOf(damBreakElasticWall()).state;
    const auto solid = directedEdges(state.mesh.solid);
    for (const auto& face : patchOf(state, "wallBase").faces) EXPECT_EQ(solid.count(face), 1u);
}

TEST(Conformity, velocities) {
    const auto state = meshOf(dictOf(fluidBody("water", "(0 0) (1 0) (1 1) (0 1)", "velocity (1 -2);") +
                                         solidBody("lid", "(0 1) (1 1) (1 1.5) (0 1.5)", "velocity (0 3 0);"),
                                     "floor { points ((0 0) (1 0)); }"))
                           .state;
    for (int i = 0; i < state.nodes.size(); ++i) {
        const double y = state.nodes.x[i].y();
        const Vec<2> expected = y == 0 ? Vec<2>(1, 0) : y < 1 ? Vec<2>(1, -2) : Vec<2>(0, 3);
        EXPECT_EQ(state.nodes.v[i], expected);
    }
}

int slidingNodes(const State<2>& state) {
    return static_cast<int>(
        std::count_if(state.nodes.wall.begin(), state.nodes.wall.end(), [](const auto& w) { return isSupported(w); }));
}

TEST(Conformity, ownSizeOfAWallRefinesTheFluid) {
    const auto state =
        meshOf(dictOf(fluidBody("water", "(0 0) (1 0) (1 1) (0 1)"), "floor { points ((0 0) (1 0)); meshSize 0.02; }"))
            .state;
    EXPECT_EQ(slidingNodes(state), 51);
    expectSound(state);
}

TEST(Conformity, defaultSizeOfAWallFollowsTheBody) {
    const auto state = meshOf(dictOf(fluidBody("water", "(0 0) (1 0) (1 1) (0 1)", "meshSize 0.2;"),
                                     "floor { points ((0 0) (1 0)); }"))
                           .state;
    EXPECT_EQ(slidingNodes(state), 6);
}

}  // namespace
}  // namespace pfem::testing
