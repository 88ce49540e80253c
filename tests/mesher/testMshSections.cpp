// What .msh files have besides nodes and elements: places on the geometry, parts, any order, marks of other systems.

#include <gtest/gtest.h>

#include "mshCase.hpp"

using namespace pfem;
using namespace pfem::testing;

namespace {

TEST(MshSections, parametricNodes) {
    for (const bool four : {false, true})
        for (const bool binary : {false, true}) expectReadAgain({.four = four, .binary = binary, .parametric = true});
}

TEST(MshSections, parts) {
    for (const bool four : {false, true})
        for (const bool binary : {false, true}) expectReadAgain({.four = four, .binary = binary, .parts = 3});
}

// The edges between two parts are no edges of a group, although Gmsh gives them the number of the surface's.
TEST(MshSections, cutsBetweenPartsAreInNoGroup) {
    const MshCase c;
    const auto mesh = readMsh(c.write({.four = true, .parts = 2}));
    for (const auto& name : mesh.groupNames(1)) EXPECT_NE(name, "1");
}

TEST(MshSections, anyOrderAndWhatIsNotNeeded) {
    for (const bool four : {false, true})
        for (const bool binary : {false, true}) {
            expectReadAgain({.four = four, .binary = binary, .namesLast = true});
            expectReadAgain({.four = four, .binary = binary, .comments = true, .results = true});
        }
}

TEST(MshSections, marksOfOtherSystems) {
    for (const bool four : {false, true}) {
        expectReadAgain({.four = four, .mark = true, .windows = true});
        expectReadAgain({.four = four, .comments = true, .windows = true});
        expectReadAgain({.four = four, .binary = true, .mark = true});
    }
}

TEST(MshSections, roundingLeavesThePlaneNot) {
    expectReadAgain({.height = 1e-9});
    expectReadAgain({.four = true, .height = -1e-9});
    EXPECT_NE(refusal({.height = 1e-3}).find("leaves the plane z = 0 by 0.001"), std::string::npos);
}

// Gmsh's SaveAll writes no groups in 2.2: then each entity is one, and the message says why the names are in vain.
TEST(MshSections, withoutGroupsTheEntitiesAreGroups) {
    const std::string message = refusal({.saveAll = true});
    for (const char* part : {"Unknown group of triangles water", "surface 1", "Mesh.SaveAll"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find("triangless"), std::string::npos) << message;
    EXPECT_EQ(refusal({.four = true, .saveAll = true}).find("Mesh.SaveAll"), std::string::npos);
    const MshCase c;
    const auto four = readMsh(c.write({.four = true, .saveAll = true}));
    const auto mesh = takeMesh(
        describe("meshFile \"x.msh\"; bodies { a { type fluid; material water; group \"surface 1\"; } }"), four);
    EXPECT_EQ(mesh.state.mesh.fluid.size(), c.state.mesh.fluid.size());
}

// The edge of a patch that is written once for each of two entities is one face.
TEST(MshSections, doubledEdgesAreOne) {
    const MshCase c;
    std::string text = mshText(c.state, {});
    const auto begin = text.find("$Elements\n") + 10, end = text.find('\n', begin);
    const long n = std::stol(text.substr(begin, end - begin));
    text.replace(begin, end - begin, std::to_string(2 * n));
    const auto first = text.find('\n', begin) + 1;
    std::string lines = text.substr(first, text.find("$EndElements") - first);
    std::string edges;
    std::istringstream stream(lines);
    long copies = 0;
    for (std::string line; std::getline(stream, line);)
        if (line.find(" 1 2 ") != std::string::npos && line.find(" 1 2 ") < 6) edges += line + "\n", ++copies;
    text.replace(begin, std::to_string(2 * n).size(), std::to_string(n + copies));
    text.insert(text.find("$EndElements"), edges);
    ASSERT_GT(copies, 0);
    expectSame(c.state, takeMesh(c.description(), readMsh(c.folder.write("twice.msh", text))).state);
}

}  // namespace
