// Meshes of several bodies and walls in space.

#include "spaceCases.hpp"

#include <fstream>

#include "io/stateDimension.hpp"
#include "io/stateFiles.hpp"
#include "mesh/wallBins.hpp"
#include "mshCase.hpp"

using namespace pfem;
using namespace pfem::testing;

namespace {

const SpaceMeshResult& poolMesh() {
    static const SpaceMeshResult result = spaceMeshOf(pool());
    return result;
}

TEST(SpaceMesh, BodiesThatTouchShareTheirNodes) {
    const auto& state = poolMesh().state;
    expectSound(state);
    expectGood(state);
    EXPECT_EQ(state.mesh.materials, (std::vector<std::string>{"water", "oil", "rubber"}));
    const auto volume = [&](int b, const Cells<3>& cells) {
        return tetraQuality(state.nodes, cells, poolMesh().bodies[b].first, poolMesh().bodies[b].last).volume;
    };
    EXPECT_NEAR(volume(0, state.mesh.fluid), 0.48 - 0.2 * 0.2 * 0.6, 1e-12);
    EXPECT_NEAR(volume(1, state.mesh.solid), 0.2 * 0.2 * 0.9, 1e-12);
    EXPECT_NEAR(volume(2, state.mesh.solid), 0.08, 1e-12);
    // the water's faces at the rubber are the rubber's own
    const auto fluid = directedFaces(state.mesh.fluid), solid = directedFaces(state.mesh.solid);
    double common = 0;
    for (const auto& [face, n] : fluid)
        if (solid.count(turned(face))) common += faceArea<3>(state.nodes.x, face).norm();
    EXPECT_NEAR(common, 4 * 0.2 * 0.6 + 0.8 - 0.04, 1e-12);
}

TEST(SpaceMesh, PatchesOfSolids) {
    const auto& state = poolMesh().state;
    EXPECT_NEAR(areaOf(state, "top"), 0.04, 1e-13);
    EXPECT_NEAR(areaOf(state, "base"), 0.8, 1e-12);
    EXPECT_NEAR(areaOf(state, "left"), 0.08, 1e-13);
    for (const auto& face : patchOf(state, "base").faces) EXPECT_LT(faceArea<3>(state.nodes.x, face)[2], 0);
    for (const auto& face : patchOf(state, "top").faces)
        for (const int i : face) EXPECT_EQ(state.nodes.x[i][2], 0.9);
}

TEST(SpaceMesh, WallsLookAwayFromTheFluid) {
    const auto& state = poolMesh().state;
    EXPECT_NEAR(areaOf(state, "tank"), 2 * 1.2 * 1.8, 1e-12);
    for (const auto& face : patchOf(state, "tank").faces) {
        const Vec<3> middle = (state.nodes.x[face[0]] + state.nodes.x[face[1]] + state.nodes.x[face[2]]) / 3;
        EXPECT_GT(faceArea<3>(state.nodes.x, face).dot(middle - Vec<3>(0.5, 0.4, 0.6)), 0);
    }
    const std::string outside =
        "meshSize 0.1; geometry { w { type box; min (0 0 0); max (1 1 0.5); } p { type cylinder; point1 (0.5 0.5 -1); "
        "point2 "
        "(0.5 0.5 1); radius 0.2; } f { type plane; point (0.5 0.5 0); normal (0 0 -1); side 4; } } bodies { water { "
        "type "
        "fluid; material water; geometry w; subtract p; } } walls { pier { geometry p; } floor { geometry f; } }";
    const auto result = spaceMeshOf(outside).state;
    expectSound(result);
    for (const auto& face : patchOf(result, "pier").faces) {  // into the pier
        const Vec<3> middle = (result.nodes.x[face[0]] + result.nodes.x[face[1]] + result.nodes.x[face[2]]) / 3;
        if (std::abs(middle[2]) > 0.5) continue;
        EXPECT_LT(faceArea<3>(result.nodes.x, face).dot(middle - Vec<3>(0.5, 0.5, middle[2])), 0);
    }
    for (const auto& face : patchOf(result, "floor").faces) EXPECT_LT(faceArea<3>(result.nodes.x, face)[2], 0);
}

TEST(SpaceMesh, FluidKnowsItsWalls) {
    const auto& state = poolMesh().state;
    std::vector<Face<3>> faces;
    for (const auto& patch : state.mesh.patches) faces.insert(faces.end(), patch.faces.begin(), patch.faces.end());
    std::set<int> solid, fluid;
    for (const auto& s : state.mesh.solid.nodes) solid.insert(s.begin(), s.end());
    for (const auto& s : state.mesh.fluid.nodes) fluid.insert(s.begin(), s.end());
    std::vector<bool> isWall;
    for (const auto& patch : state.mesh.patches) isWall.push_back(patch.name == "tank");
    const auto walls = wallFaces<3>(state.mesh.patches, isWall, state.nodes.x);
    const WallBins<3> places(walls, state.nodes.x);
    int onWalls = 0, onEdges = 0;
    for (int i = 0; i < state.nodes.size(); ++i) {
        const auto& x = state.nodes.x[i];
        const bool side = x[0] == 0 || x[0] == 1, end = x[1] == 0 || x[1] == 0.8;
        const bool at = fluid.count(i) && !solid.count(i) && x[2] < 1 && (side || end);
        EXPECT_EQ(isSupported(state.nodes.wall[i]), at) << x.transpose();
        if (!at) continue;
        ++onWalls;
        EXPECT_EQ(places.supportsAt(x, 1e-9), state.nodes.wall[i]);
        EXPECT_EQ(nSupports(state.nodes.wall[i]), side && end ? 2 : 1);
        std::set<int> across;  // axes of the normals
        for (int k = 0; k < nSupports(state.nodes.wall[i]); ++k) {
            Eigen::Index axis = 0;
            const auto& face = walls[state.nodes.wall[i][k]].nodes;
            EXPECT_NEAR(inwardNormal<3>(state.nodes.x, face).cwiseAbs().maxCoeff(&axis), 1, 1e-12);
            EXPECT_NEAR(state.nodes.x[face[0]][axis], x[axis], 1e-12);
            across.insert(static_cast<int>(axis));
        }
        EXPECT_EQ(across.size(), side && end ? 2u : 1u);
        onEdges += side && end;
        EXPECT_EQ(state.nodes.v[i][0], side ? 0.0 : 1.0);
        EXPECT_NEAR(state.nodes.v[i][1], end ? 0.0 : 2.0, 1e-15);
        EXPECT_EQ(state.nodes.v[i][2], 3);
    }
    EXPECT_GT(onWalls, 100);
    EXPECT_GE(onEdges, 4 * 5);
}

TEST(SpaceMesh, IsReadBackAndMadeAgainBitForBit) {
    const Folder folder;
    const auto& state = poolMesh().state;
    writeState(folder.path / "0", state);
    EXPECT_EQ(stateDimension(folder.path / "0"), 3);
    const auto again = readState<3>(folder.path / "0");
    EXPECT_EQ(again.mesh.fluid.nodes, state.mesh.fluid.nodes);
    EXPECT_EQ(again.mesh.solid.nodes, state.mesh.solid.nodes);
    EXPECT_EQ(again.nodes.x, state.nodes.x);
    EXPECT_EQ(again.nodes.v, state.nodes.v);
    EXPECT_EQ(again.nodes.wall, state.nodes.wall);
    ASSERT_EQ(again.mesh.patches.size(), state.mesh.patches.size());
    for (std::size_t p = 0; p < state.mesh.patches.size(); ++p) {
        EXPECT_EQ(again.mesh.patches[p].name, state.mesh.patches[p].name);
        EXPECT_EQ(again.mesh.patches[p].faces, state.mesh.patches[p].faces);
    }
    const auto second = spaceMeshOf(pool()).state;
    EXPECT_EQ(second.nodes.x, state.nodes.x);
    EXPECT_EQ(second.mesh.fluid.nodes, state.mesh.fluid.nodes);
}

TEST(SpaceMesh, OtherSizesGoWithThatOfTheCommandLine) {
    const std::string text =
        "meshSize 0.1; bodies { water { type fluid; material water; geometry { type box; min (0 0 0); max (1 1 1); } } "
        "plate { type solid; material rubber; meshSize 0.02; geometry { type box; min (1 0 0); max (1.1 1 1); } } } "
        "refinements { a { type sphere; centre (0 0 0); radius 0.2; meshSize 0.05; } }";
    const auto mesh = describeSpace(text, "", 0.3);
    EXPECT_EQ(mesh.meshSize, 0.3);
    EXPECT_EQ(mesh.bodies[0].meshSize, 0);
    EXPECT_DOUBLE_EQ(mesh.bodies[1].meshSize, 0.06);
    EXPECT_DOUBLE_EQ(mesh.refinements[0].meshSize, 0.15);
    EXPECT_EQ(describeSpace(text).bodies[1].meshSize, 0.02);
}

TEST(SpaceMesh, SizesByBodyAndPlace) {
    const std::string text =
        "meshSize 0.1; geometry { w { type box; min (0 0 0); max (1 1 1); } } bodies { water { type fluid; material "
        "water; "
        "geometry w; } } refinements { a { type box; min (0 0 0); max (0.3 0.3 0.3); meshSize 0.05; } b { type sphere; "
        "centre "
        "(1 1 1); radius 0.2; meshSize 0.06; } c { type surface; geometry { type disk; origin (1 0 0.5); normal (0 0 "
        "1); "
        "radius 0.2; } distance 0.05; meshSize 0.05; } }";
    const auto state = spaceMeshOf(text).state;
    expectSound(state);
    const auto meanEdge = [&](const Vec<3>& place, double radius) {
        double sum = 0;
        int n = 0;
        for (const auto& s : state.mesh.fluid.nodes) {
            if ((simplexCentroid<3>(state.nodes.x, s) - place).norm() > radius) continue;
            for (int k = 0; k < 4; ++k)
                for (int l = k + 1; l < 4; ++l) sum += (state.nodes.x[s[k]] - state.nodes.x[s[l]]).norm(), ++n;
        }
        return sum / n;
    };
    EXPECT_NEAR(meanEdge({0.1, 0.1, 0.1}, 0.15), 0.05, 0.01);
    EXPECT_NEAR(meanEdge({0.95, 0.95, 0.95}, 0.15), 0.06, 0.012);
    EXPECT_NEAR(meanEdge({0.95, 0.05, 0.5}, 0.08), 0.05, 0.01);
    EXPECT_NEAR(meanEdge({0.1, 0.9, 0.1}, 0.2), 0.1, 0.02);
    for (int i = 0; i < state.nodes.size(); ++i)
        EXPECT_LE(state.nodes.h[i], state.nodes.x[i].maxCoeff() < 0.3 ? 0.05 : 0.1);
}

}  // namespace
