// Adjacency and what follows from it: kinds of faces, roles of nodes.

#include "mesh/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "mesh/wallUnder.hpp"
#include "support/cases3.hpp"

using namespace pfem;

namespace {

//   6----7----8      fluid: the four triangles of the two upper cells (nodes 3 4 5 6 7 8)
//   | f / | f /|     solid: the four of the lower cells (0 1 2 3 4 5)
//   | /   | /  |     wall: the right side, under the nodes 5 and 8
//   3----4----5      node 9 alone, nodes 10 11 12 points of the wall
//   | s / | s /|
//   0----1----2
Mesh<2> layers() {
    Mesh<2> mesh;
    mesh.solid.nodes = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    mesh.fluid.nodes = {{3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}};
    mesh.solid.material.assign(4, 1);
    mesh.fluid.material.assign(4, 0);
    mesh.patches = {{"side", {{10, 11}, {11, 12}}}};
    return mesh;
}

const Points<2> places = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2},
                          {1, 2}, {2, 2}, {5, 5}, {2, 1}, {2, 2}, {2, 3}};

/// Nodes without walls, but for these.
std::vector<Supports<2>> supports(int n, const std::map<int, Supports<2>>& of = {}) {
    std::vector<Supports<2>> all(n, unsupported<2>());
    for (const auto& [node, faces] : of) all[node] = faces;
    return all;
}

Topology<2> layersTopology() {
    return makeTopology<2>(layers(), {PatchKind::wall}, places, supports(13, {{8, {0, -1}}}));
}

std::map<std::set<int>, FaceKind> facesOf(const Topology<2>& t) {
    std::map<std::set<int>, FaceKind> kinds;
    for (const auto& face : t.faces) kinds[{face.nodes[0], face.nodes[1]}] = face.kind;
    return kinds;
}

TEST(Adjacency, cellsAndNodesAroundANode) {
    const auto mesh = layers();
    const auto around = nodeToCells<2>(mesh.fluid.nodes, 11);
    EXPECT_EQ(around.count(4), 3);
    EXPECT_EQ(around.count(0), 0);
    EXPECT_EQ(around.count(9), 0);
    for (int i = 0; i < 11; ++i)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            EXPECT_EQ(mesh.fluid.nodes[around.cell[s]][around.corner[s]], i);
    const auto [ring, boundary] = surroundings<2>(mesh.fluid.nodes, around);
    const std::vector<int> of4(ring.node.begin() + ring.start[4], ring.node.begin() + ring.start[5]);
    EXPECT_EQ(of4, (std::vector<int>{3, 5, 7, 8}));
    const auto faces = boundaryFaces<2>(mesh.fluid.nodes, around);  // found in another way
    ASSERT_EQ(boundary.size(), faces.size());
    for (std::size_t k = 0; k < faces.size(); ++k) {
        EXPECT_EQ(boundary[k].nodes, faces[k].nodes);
        EXPECT_EQ(boundary[k].cell, faces[k].cell);
        EXPECT_EQ(boundary[k].opposite, faces[k].opposite);
    }
}

/// A cube of tetrahedra, of which some are missing: nodes around which all cells are there are told by Euler's formula,
/// the others' faces are looked for; boundaryFaces() looks for all.
TEST(Adjacency, openFacesAreFoundAroundAllNodesInSpace) {
    constexpr int m = 7;
    State<3> state;
    test::addLattice(state, state.mesh.fluid, 0, {0, 0, 0}, {m - 1, m - 1, m - 1}, 1);
    const int nNodes = state.nodes.size();
    std::mt19937 random(2);
    for (const double kept : {0.05, 0.5, 0.9, 0.99, 1.0}) {
        std::vector<Simplex<3>> cells;
        for (const auto& cell : state.mesh.fluid.nodes)
            if (std::uniform_real_distribution<>(0, 1)(random) < kept) cells.push_back(cell);
        const auto around = nodeToCells<3>(cells, nNodes);
        const auto [ring, boundary] = surroundings<3>(cells, around);
        const auto faces = boundaryFaces<3>(cells, around);
        ASSERT_EQ(boundary.size(), faces.size()) << kept;
        if (kept == 1.0) {
            EXPECT_EQ(faces.size(), 12u * (m - 1) * (m - 1));
        }
        for (std::size_t k = 0; k < faces.size(); ++k) {
            EXPECT_EQ(boundary[k].nodes, faces[k].nodes);
            EXPECT_EQ(boundary[k].cell, faces[k].cell);
            EXPECT_EQ(boundary[k].opposite, faces[k].opposite);
        }
        std::vector<std::set<int>> expected(nNodes);
        for (const auto& cell : cells)
            for (const int i : cell)
                for (const int j : cell)
                    if (i != j) expected[i].insert(j);
        for (int i = 0; i < nNodes; ++i)
            EXPECT_EQ(std::vector<int>(ring.node.begin() + ring.start[i], ring.node.begin() + ring.start[i + 1]),
                      std::vector<int>(expected[i].begin(), expected[i].end()));
    }
}

TEST(Adjacency, boundaryFacesHaveTheirCellOnTheLeft) {
    const auto mesh = layers();
    const Points<2>& x = places;
    const auto faces = boundaryFaces<2>(mesh.fluid.nodes, nodeToCells<2>(mesh.fluid.nodes, 11));
    EXPECT_EQ(faces.size(), 6u);
    for (const auto& face : faces) {
        const auto& cell = mesh.fluid.nodes[face.cell];
        const int opposite = cell[face.opposite];
        EXPECT_TRUE(opposite != face.nodes[0] && opposite != face.nodes[1]);
        const Vec<2> t = x[face.nodes[1]] - x[face.nodes[0]], o = x[opposite] - x[face.nodes[0]];
        EXPECT_GT(t[0] * o[1] - t[1] * o[0], 0);
    }
}

TEST(Topology, kindsOfFaces) {
    const auto t = layersTopology();
    const auto kinds = facesOf(t);
    EXPECT_EQ(kinds.size(), 6u);
    EXPECT_EQ(kinds.at({3, 4}), FaceKind::interface);
    EXPECT_EQ(kinds.at({4, 5}), FaceKind::interface);
    EXPECT_EQ(kinds.at({5, 8}), FaceKind::wall);
    EXPECT_EQ(kinds.at({7, 8}), FaceKind::freeSurface);
    EXPECT_EQ(kinds.at({6, 7}), FaceKind::freeSurface);
    EXPECT_EQ(kinds.at({3, 6}), FaceKind::freeSurface);
}

TEST(Topology, rolesOfNodes) {
    const auto t = layersTopology();
    const auto is = [](const auto& flag) {
        std::vector<int> nodes;
        for (int i = 0; i < 13; ++i)
            if (flag(i)) nodes.push_back(i);
        return nodes;
    };
    EXPECT_EQ(is([&](int i) { return t.onSolid[i]; }), (std::vector<int>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(is([&](int i) { return t.wallPoint[i]; }), (std::vector<int>{10, 11, 12}));
    EXPECT_EQ(is([&](int i) { return t.ofFluid(i); }), (std::vector<int>{6, 7, 8, 9}));
    EXPECT_EQ(is([&](int i) { return t.onWall[i]; }), (std::vector<int>{8}));
    EXPECT_EQ(is([&](int i) { return isSupported(t.supports[i]); }), (std::vector<int>{5, 8}));  // the solid touches
    EXPECT_EQ(is([&](int i) { return t.freeSurface[i]; }), (std::vector<int>{3, 6, 7, 8}));
    EXPECT_EQ(is([&](int i) { return t.wet(i); }), (std::vector<int>{3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(is([&](int i) { return t.interface(i); }), (std::vector<int>{3, 4, 5}));
    EXPECT_EQ(is([&](int i) { return t.isolated(i); }), (std::vector<int>{9}));
}

// Nodes slide along walls that have points of their own; one in a corner lies on two.
TEST(Topology, facesOfSlidingNodes) {
    // floor from point 0 to point 5, wall from there up to 7; nodes 1 2 slide along the floor, 6 along the wall, 4 is
    // held in the corner
    Mesh<2> mesh;
    mesh.fluid.nodes = {{1, 2, 3}, {2, 4, 6}, {2, 6, 3}};
    mesh.fluid.material.assign(3, 0);
    mesh.patches = {{"outlet", {{8, 9}}}, {"tank", {{0, 5}, {5, 7}}}};
    const Points<2> x = {{-1, 0}, {0, 0}, {1, 0}, {1, 1}, {2, 0}, {2, 0}, {2, 1}, {2, 5}, {0, 9}, {1, 9}};
    const auto wall = supports(10, {{1, {1, -1}}, {2, {1, -1}}, {4, {1, 2}}, {6, {2, -1}}});  // over all patches
    const auto t = makeTopology<2>(mesh, {PatchKind::symmetry, PatchKind::wall}, x, wall);
    const auto kinds = facesOf(t);
    EXPECT_EQ(kinds.size(), 5u);
    EXPECT_EQ(kinds.at({1, 2}), FaceKind::wall);
    EXPECT_EQ(kinds.at({2, 4}), FaceKind::wall);  // with the corner
    EXPECT_EQ(kinds.at({4, 6}), FaceKind::wall);
    EXPECT_EQ(kinds.at({3, 6}), FaceKind::freeSurface);
    EXPECT_EQ(kinds.at({1, 3}), FaceKind::freeSurface);
    EXPECT_TRUE(t.onWall[1] && t.onWall[6] && t.onWall[4]);
    EXPECT_FALSE(t.isolated(0));  // a point of a wall
    mesh.fluid.nodes = {{2, 6, 3}};
    mesh.fluid.material = {0};
    const auto across = facesOf(makeTopology<2>(mesh, {PatchKind::symmetry, PatchKind::wall}, x, wall));
    EXPECT_EQ(across.at({2, 6}), FaceKind::freeSurface);  // two walls: across the corner, not along a wall
}

// Round a convex corner there is no air; a face of one region that looks away from the wall is the surface of a puddle.
TEST(Topology, facesOnBentWalls) {
    Mesh<2> mesh;  // a step down: from (0 1) to (1 1), then to (1 0); nodes 3 and 4 on both sides of its corner
    mesh.fluid.nodes = {{3, 4, 5}};
    mesh.fluid.material = {0};
    mesh.patches = {{"step", {{0, 1}, {1, 2}}}};
    const Points<2> x = {{0, 1}, {1, 1}, {1, 0}, {0.9, 1}, {1, 0.8}, {1.2, 1.1}};
    const auto step = facesOf(makeTopology<2>(mesh, {PatchKind::wall}, x, supports(6, {{3, {0, -1}}, {4, {1, -1}}})));
    EXPECT_EQ(step.at({3, 4}), FaceKind::wall);
    EXPECT_EQ(step.at({4, 5}), FaceKind::freeSurface);

    mesh.fluid.nodes = {{3, 4, 5}};  // a trough with bends of 19 degrees
    const Points<2> trough = {{-1, 0.16}, {0, 0}, {1, 0.16}, {-0.5, 0.08}, {0, 0}, {0.5, 0.08}};
    const auto puddle =
        makeTopology<2>(mesh, {PatchKind::wall}, trough, supports(6, {{3, {0, -1}}, {4, {0, -1}}, {5, {1, -1}}}));
    EXPECT_EQ(puddle.walls[0].region, puddle.walls[1].region);
    EXPECT_EQ(facesOf(puddle).at({3, 4}), FaceKind::wall);
    EXPECT_EQ(facesOf(puddle).at({4, 5}), FaceKind::wall);
    EXPECT_EQ(facesOf(puddle).at({3, 5}), FaceKind::freeSurface);
}

// A round tank a little more than half full: the normals of its walls at the two ends of the surface cancel but for a
// small rest, which points down. That is no wall over the water.
TEST(Topology, surfaceFromWallToWallOfARoundTank) {
    const auto at = [](double degrees) {
        return Vec<2>(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
    };
    Mesh<2> mesh;
    Points<2> x;
    mesh.patches.push_back({"tank", {}});
    for (int k = 0; k < 15; ++k) {
        x.push_back(at(165 + 15 * k));
        if (k > 0) mesh.patches[0].faces.push_back({k - 1, k});
    }
    x.push_back(0.5 * (x[0] + x[1]));    // 15: the left end of the surface
    x.push_back(0.5 * (x[13] + x[14]));  // 16: the right one
    x.emplace_back(0, -0.1);
    mesh.fluid.nodes = {{15, 17, 16}};
    mesh.fluid.material = {0};
    const auto t = makeTopology<2>(mesh, {PatchKind::wall}, x, supports(18, {{15, {0, -1}}, {16, {13, -1}}}));
    EXPECT_EQ(t.walls[0].region, t.walls[13].region);
    EXPECT_EQ(facesOf(t).at({15, 16}), FaceKind::freeSurface);
}

TEST(Topology, twoFreeSurfaceNodesDoNotMakeAFace) {
    // a strip of one row: every node is on the free surface, inner edges are no faces
    Mesh<2> mesh;
    mesh.fluid.nodes = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    mesh.fluid.material.assign(4, 0);
    const auto t = makeTopology<2>(mesh, {}, Points<2>(6, Vec<2>::Zero()), supports(6));
    const auto kinds = facesOf(t);
    EXPECT_EQ(kinds.size(), 6u);
    EXPECT_EQ(kinds.count({1, 4}), 0u);
    EXPECT_EQ(kinds.count({0, 4}), 0u);
    for (int i = 0; i < 6; ++i) EXPECT_TRUE(t.freeSurface[i]);
}

// A fluid triangle whose three nodes all lie on a concave solid is fluid, its free face included: what faces are is
// said by the cells, not by flags of nodes.
TEST(Topology, faceAcrossAConcaveSolidCorner) {
    // solid: L of two triangles around the corner 1; fluid: triangle (0 ... ) in the corner
    const std::vector<Simplex<2>> solid = {{3, 1, 0}, {1, 4, 2}};
    Mesh<2> mesh;
    mesh.solid.nodes = solid;
    mesh.solid.material.assign(2, 1);
    mesh.fluid.nodes = {{0, 1, 2}};
    mesh.fluid.material.assign(1, 0);
    const auto t = makeTopology<2>(mesh, {}, {{1, 0}, {0, 0}, {0, 1}, {1, -1}, {-1, 1}}, supports(5));
    const auto kinds = facesOf(t);
    EXPECT_EQ(kinds.at({0, 1}), FaceKind::interface);
    EXPECT_EQ(kinds.at({1, 2}), FaceKind::interface);
    EXPECT_TRUE(t.wet(0) && t.wet(1) && t.wet(2));
}

TEST(Topology, faceOnASymmetryPatchIsClosed) {
    Mesh<2> mesh;
    mesh.fluid.nodes = {{0, 1, 2}};
    mesh.fluid.material.assign(1, 0);
    mesh.patches = {{"plane", {{0, 1}}}};
    const Points<2> x = {{0, 0}, {1, 0}, {0, 1}};
    const auto kinds = facesOf(makeTopology<2>(mesh, {PatchKind::symmetry}, x, supports(3)));
    EXPECT_EQ(kinds.at({0, 1}), FaceKind::wall);
    EXPECT_EQ(kinds.at({1, 2}), FaceKind::freeSurface);
    const auto clamped = facesOf(makeTopology<2>(mesh, {PatchKind::edge}, x, supports(3)));
    EXPECT_EQ(clamped.at({0, 1}), FaceKind::freeSurface);
}

TEST(Topology, threeDimensions) {
    Mesh<3> mesh;  // a fluid tetrahedron on a solid one
    mesh.fluid.nodes = {{0, 1, 2, 3}};
    mesh.fluid.material = {0};
    mesh.solid.nodes = {{0, 2, 1, 4}};
    mesh.solid.material = {1};
    const auto t =
        makeTopology<3>(mesh, {}, Points<3>(5, Vec<3>::Zero()), std::vector<Supports<3>>(5, unsupported<3>()));
    int interface = 0, surface = 0;
    for (const auto& face : t.faces) {
        interface += face.kind == FaceKind::interface;
        surface += face.kind == FaceKind::freeSurface;
    }
    EXPECT_EQ(interface, 1);
    EXPECT_EQ(surface, 3);
}

// A node of the floor comes to the side, between two that are on their edge: the face of the three has no area and no
// normal. It lies on both walls; no surface is open there.
TEST(Topology, aFaceThatCollapsesOnTheEdgeOfTwoWalls) {
    Mesh<3> mesh;
    mesh.fluid.nodes = {{0, 1, 2, 3}};
    mesh.fluid.material = {0};
    mesh.patches = {{"floor", {{4, 6, 5}, {4, 7, 6}}}, {"side", {{8, 9, 10}, {8, 10, 11}}}};
    Points<3> x{{0, 0, 0}, {1, 0, 0},  {0.4, 0.3, 0}, {0.5, 0.5, 0.5}, {-1, 0, 0}, {2, 0, 0},
                {2, 1, 0}, {-1, 1, 0}, {-1, 0, 0},    {2, 0, 0},       {2, 0, 1},  {-1, 0, 1}};
    std::vector<Supports<3>> held(x.size(), unsupported<3>());
    held[0] = held[1] = {0, 2, -1};
    held[2] = {0, -1, -1};
    const auto bottom = [&] {
        const auto t = makeTopology<3>(mesh, {PatchKind::wall, PatchKind::wall}, x, held);
        const auto face = std::find_if(t.faces.begin(), t.faces.end(), [](const auto& f) {
            return std::find(f.nodes.begin(), f.nodes.end(), 3) == f.nodes.end();
        });
        EXPECT_EQ(face->kind, FaceKind::wall);
        const auto common = commonWalls<3>(t, face->nodes);
        return std::tuple(t.walls[face->wall].patch, nSupports(common), isAlongEdge<3>(x, face->nodes, common));
    };
    EXPECT_EQ(bottom(), std::tuple(0, 1, false));
    x[2][1] = 0;
    held[2] = {0, 2, -1};
    EXPECT_EQ(bottom(), std::tuple(0, 2, true));
}

}  // namespace
