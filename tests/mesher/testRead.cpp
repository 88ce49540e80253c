// The words of meshDict.

#include <sstream>

#include "cases.hpp"

namespace pfem::testing {
namespace {

TEST(Read, tutorialDictionary) {
    const auto dict = Dictionary::read(PFEM_SOURCE_DIR "/tutorials/damBreakElasticWall/system/meshDict");
    const auto mesh = readMeshDict(dict, {"water", "rubber"});
    ASSERT_EQ(mesh.bodies.size(), 2u);
    EXPECT_EQ(mesh.bodies[0].type, BodyType::fluid);
    EXPECT_NEAR(mesh.bodies[0].points[2].y(), 0.292, 1e-15);
    EXPECT_EQ(mesh.bodies[1].patches.at("wallBase").size(), 1u);
    EXPECT_EQ(mesh.walls.at(0).points.size(), 4u);
}

TEST(Read, allWords) {
    const auto dict = Dictionary::parse(
        "meshSize 0.1; bodies { a { type solid; material oil; vertices ((0 0) (1 0) (1 1) (0 1)); meshSize "
        "0.2; "
        "velocity (1 2 0); pattern checkerboard; cells (3 4); holes (); edges (arc 0 1 (0.5 -0.1)); "
        "patches { p { edges ((0 1) (2 3)); } } } } "
        "walls { w { points ((0 0) (1 0) (1 1)); closed yes; meshSize 0.3; edges (arc 1 0 (0.5 -0.1)); } }");
    const auto mesh = readMeshDict(dict, {"oil"});
    const Body& body = mesh.bodies.at(0);
    EXPECT_EQ(body.type, BodyType::solid);
    EXPECT_EQ(body.material, "oil");
    EXPECT_EQ(body.meshSize, 0.2);
    EXPECT_EQ(body.velocity, Vec<2>(1, 2));
    EXPECT_EQ(body.pattern, Pattern::checkerboard);
    EXPECT_EQ(body.cells, (std::array<int, 2>{3, 4}));
    EXPECT_EQ(body.arcs.at(0).through, Vec<2>(0.5, -0.1));
    EXPECT_EQ(body.patches.at("p").at(1), (std::array<int, 2>{2, 3}));
    EXPECT_TRUE(mesh.walls.at(0).closed);
    EXPECT_EQ(mesh.walls.at(0).meshSize, 0.3);
    std::ostringstream warnings;
    warnUnused(dict, warnings);
    EXPECT_EQ(warnings.str(), "");
}

TEST(Read, sizeOfTheCommandLine) {
    const auto mesh = describe(damBreakElasticWall(), 0.006);
    EXPECT_EQ(mesh.meshSize, 0.006);
    EXPECT_EQ(mesh.bodies[0].meshSize, 0);
}

// What has a size of its own keeps the ratio to the size for all.
TEST(Read, otherSizesGoWithThatOfTheCommandLine) {
    const std::string text =
        "meshSize 0.02; bodies { water { type fluid; material water; vertices ((0 0) (1 0) (1 1) (0 1)); } plate { "
        "type "
        "solid; material rubber; meshSize 0.005; vertices ((1 0) (1.1 0) (1.1 1) (1 1)); } } walls { tank { meshSize "
        "0.01; points ((0 2) (0 0) (1 0)); } } refinements { toe { type box; min (0 0); max (0.1 0.1); meshSize 0.004; "
        "} "
        "}";
    const auto mesh = describe(text, 0.03);
    EXPECT_EQ(mesh.meshSize, 0.03);
    EXPECT_EQ(mesh.bodies[0].meshSize, 0);
    EXPECT_DOUBLE_EQ(mesh.bodies[1].meshSize, 0.0075);
    EXPECT_DOUBLE_EQ(mesh.walls[0].meshSize, 0.015);
    EXPECT_DOUBLE_EQ(mesh.refinements[0].meshSize, 0.006);
    EXPECT_EQ(describe(text).bodies[1].meshSize, 0.005);
    EXPECT_EQ(describe(text.substr(text.find("bodies")), 0.03).bodies[1].meshSize, 0.005);  // nothing to be in ratio to
}

TEST(Read, reportNamesAllParts) {
    const auto description = describe(damBreakElasticWall());
    const auto report = meshReport(description, buildMesh(description));
    for (const char* part : {"water", "wall ", "rubber", "tank", "wallBase", "fluid triangles"})
        EXPECT_NE(report.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace pfem::testing
