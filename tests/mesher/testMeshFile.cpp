// Meshes of other programs: what the mesher has made, written as Gmsh would, gives the same state again.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/stateFiles.hpp"
#include "mshCase.hpp"

using namespace pfem;
using namespace pfem::testing;

namespace {

State<2> scaledBy(double factor, State<2> state) {
    for (auto& x : state.nodes.x) x *= factor;
    return state;
}

const std::string& bodies = fileBodies;
const std::string& tank = fileTank;

TEST(MeshFile, Msh2AndMsh4GiveTheSameStateAgain) {
    const Folder folder;
    const State<2> state = meshOf(damBreakElasticWall(), 0.01).state;
    const auto two = takeMesh(fileDict(bodies, tank), readMsh(folder.write("a.msh", mshText(state, {}))));
    expectSame(state, two.state);
    const auto four = takeMesh(fileDict(bodies, tank), readMsh(folder.write("b.msh", mshText(state, {.four = true}))));
    expectSame(state, four.state);
    const auto scaled = takeMesh(fileDict(bodies, tank, "scale 0.001;"),
                                 readMsh(folder.write("c.msh", mshText(scaledBy(1000, state), {}))));
    expectSame(state, scaled.state);
    EXPECT_NEAR(two.bodies[0].area, 0.146 * 0.292, 1e-12);
    EXPECT_NEAR(two.bodies[1].perimeter, 2 * (0.012 + 0.08), 1e-12);
    for (const double h : two.state.nodes.h) EXPECT_NEAR(h, 0.01, 0.004);
}

TEST(MeshFile, WallsMayBeGroupsOfEdges) {
    const Folder folder;
    const State<2> state = meshOf(damBreakElasticWall(), 0.01).state;
    // the tank's straight faces have no nodes of the fluid between: as edges of the file they are dry but for none
    State<2> fine = state;
    for (auto& patch : fine.mesh.patches) {
        if (patch.name != "tank") continue;
        patch.faces.clear();
        std::map<Face<2>, int> edges = directedEdges(state.mesh.fluid);
        for (const auto& [edge, count] : edges) {
            const Vec<2>&p = state.nodes.x[edge[0]], &q = state.nodes.x[edge[1]];
            if (!edges.count({edge[1], edge[0]}) && ((p.x() == 0 && q.x() == 0) || (p.y() == 0 && q.y() == 0)))
                patch.faces.push_back(edge);
        }
        ASSERT_GT(patch.faces.size(), 10u);
    }
    const auto result = takeMesh(fileDict(bodies, "tank { }"), readMsh(folder.write("a.msh", mshText(fine, {}))));
    EXPECT_EQ(patchOf(result.state, "tank").faces.size(), 2u);  // floor and side under the water, each straight
    EXPECT_NEAR(lengthOf(result.state, "tank"), 0.146 + 0.292, 1e-9);
}

TEST(MeshFile, VtuOfATimeFolderGivesItsFluidAgain) {
    const Folder folder;
    const State<2> state = meshOf(damBreakElasticWall(), 0.02).state;
    writeState(folder.path / "0", state);
    const auto file = readMeshFile(folder.path / "0" / "fluid.vtu", "material");
    const auto result = takeMesh(fileDict("column { type fluid; material oil; group water; }", tank), file);
    expectSound(result.state);
    EXPECT_EQ(result.state.mesh.fluid.size(), state.mesh.fluid.size());
    EXPECT_EQ(result.state.mesh.materials, std::vector<std::string>{"oil"});

    std::ifstream stream(folder.path / "0" / "fluid.vtu", std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const auto marked = readMeshFile(folder.write("marked.vtu", "\xEF\xBB\xBF" + text), "material");  // byte order mark
    EXPECT_EQ(marked.cells.size(), file.cells.size());
}

/// A square of two triangles with a wall below; line 15 on are the elements.
std::string square() {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"w\"\n1 2 \"floor\"\n$EndPhysicalNames\n"
           "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
           "$Elements\n3\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n3 1 2 2 1 1 2\n$EndElements\n";
}

struct Bad {
    std::string from, to, message;
    int line;
};

TEST(MeshFile, ErrorsNameTheLine) {
    const Folder folder;
    for (const Bad& bad : std::vector<Bad>{
             {"2.2 0 8", "4.0 0 8", "save it as 2.2 or 4.1", 2},
             {"2.2 0 8", "2.2 1 8", "other order", 0},
             {"$MeshFormat", "$NOD", "version 1: save it as 2.2 or 4.1", 1},
             {"3 1 1 0\n", "3 1 one 0\n", "'one' is not a number", 13},
             {"3 1 1 0\n", "3 1 nan 0\n", "not a finite number", 13},
             {"3 1 1 0\n", "3 1 1 0.5\n", "leaves the plane", 13},
             {"3 1 1 0\n", "2 1 1 0\n", "a second node 2", 13},
             {"3 1 1 0\n", "3 1 1\n", "4 numbers expected, 3 found", 13},
             {"$Nodes\n4", "$Nodes\n5", "$EndNodes comes before", 15},
             {"$Nodes\n4", "$Nodes\n-4", "no number of things", 10},
             {"$EndElements\n", "", "ends without $EndElements", 20},
             {"2 2 2 1 1 1 3 4", "2 2 2 1 1 1 3 9", "there is no node 9", 19},
             {"2 2 2 1 1 1 3 4", "2 9 2 1 1 1 3 4 1 2 3", "second order", 19},
             {"2 2 2 1 1 1 3 4", "2 3 2 1 1 1 2 3 4", "quadrangle", 19},
             {"2 2 2 1 1 1 3 4", "2 2 2 1 1 1 2 3", "overlaps", 19},
             {"2 2 2 1 1 1 3 4", "2 2 2 1 1 1 3 3", "no area", 19},
             {"3 1 2 2 1 1 2", "3 1 2 2 1 1 3", "on both of its sides", 20},
         }) {
        std::string text = square();
        ASSERT_NE(text.find(bad.from), std::string::npos) << bad.from;
        text.replace(text.find(bad.from), bad.from.size(), bad.to);
        const auto file = folder.write("bad.msh", text);
        try {
            takeMesh(fileDict("w { type fluid; material water; }", "floor { }"), readMsh(file));
            FAIL() << bad.to << " should fail";
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find(bad.message), std::string::npos) << error.what();
            EXPECT_EQ(error.where().line, bad.line) << error.what();
            EXPECT_EQ(error.where().file, file.string());
        }
    }
}

TEST(MeshFile, ErrorsOfTheDictionary) {
    const Folder folder;
    const auto file = readMsh(folder.write("a.msh", square()));
    const auto message = [&](const MeshDescription& description) -> std::string {
        try {
            takeMesh(description, file);
        } catch (const UserError& error) {
            EXPECT_EQ(error.where().file.substr(0, 8), "meshDict") << error.what();
            return error.what();
        }
        return "";
    };
    const std::string w = "w { type fluid; material water; }";
    EXPECT_EQ(message(fileDict(w, "floor { }")), "");
    EXPECT_NE(message(fileDict("v { type fluid; material water; }", "")).find('w'), std::string::npos);
    EXPECT_NE(message(fileDict(w, "flor { }")).find("floor"), std::string::npos);
    EXPECT_NE(message(fileDict(w, "f { points ((1 0) (0 0)); }")).find("turn its points around"), std::string::npos);
    EXPECT_THROW(fileDict("w { type fluid; material water; vertices ((0 0)); }", ""), UserError);
    EXPECT_THROW(fileDict(w, "", "scale 0;"), UserError);
    EXPECT_THROW(readMeshFile(folder.write("a.stl", ""), "material"), UserError);
    EXPECT_THROW(readMeshFile(folder.path / "none.msh", "material"), UserError);
}

TEST(MeshFile, TouchingBodiesNeedCommonNodes) {
    const Folder folder;
    // a second square beside the first one with a node in the middle of the common side; then with doubled points
    const auto text = [](const std::string& extra, int n, const std::string& cells, int m) {
        return fmt::format(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n{}$EndNodes\n"
            "$Elements\n{}\n1 2 1 1 1 2 3\n2 2 1 1 1 3 4\n{}$EndElements\n",
            n, extra, m, cells);
    };
    const std::string both = "a { type fluid; material water; group 1; } b { type solid; material rubber; group 2; }";
    const auto hanging = readMsh(folder.write("h.msh", text("5 2 0 0\n6 2 1 0\n7 1 0.5 0\n8 1 0 0\n9 1 1 0\n", 9,
                                                            "3 2 1 2 8 5 7\n4 2 1 2 7 5 6\n5 2 1 2 7 6 9\n", 5)));
    EXPECT_THROW(takeMesh(fileDict(both, ""), hanging), UserError);
    const auto doubled = readMsh(
        folder.write("d.msh", text("5 2 0 0\n6 2 1 0\n8 1 0 0\n9 1 1 0\n", 8, "3 2 1 2 8 5 6\n4 2 1 2 8 6 9\n", 4)));
    EXPECT_EQ(takeMesh(fileDict(both, ""), doubled).state.nodes.size(), 6);
}

}  // namespace
