// Tetrahedra of other programs: what the mesher has made, written as Gmsh would, gives the same state again.

#include "spaceCases.hpp"

#include <fmt/format.h>

#include <fstream>
#include <random>

#include "io/stateFiles.hpp"
#include "mesher/meshFile.hpp"
#include "mshCase.hpp"

using namespace pfem;
using namespace pfem::testing;

namespace {

const State<3>& state() {
    static const State<3> made =
        spaceMeshOf(
            "meshSize 0.25; geometry { w { type box; min (0 0 0); max (1 1 0.5); } p { type box; min (0 0 -0.25); max "
            "(1 1 0); } t { type box; min (0 0 0); max (1 1 0.5); } } bodies { water { type fluid; material water; "
            "geometry w; } plate { type solid; material rubber; geometry p; patches { base { faces zMin; } } } } walls "
            "{ tank { geometry t; open (zMin zMax); } }")
            .state;
    return made;
}

/// The faces of the water on the sides of the tank: a mesh program has no larger ones.
std::vector<Face<3>> sides(const State<3>& s) {
    std::vector<Face<3>> faces;
    const auto all = directedFaces(s.mesh.fluid);
    for (const auto& [face, n] : all) {
        const Vec<3> a = faceArea<3>(s.nodes.x, face).normalized();
        if (!all.count(turned(face)) && std::abs(a[2]) < 0.5) faces.push_back(face);
    }
    return faces;
}

std::string mshText(const State<3>& s, int version, double scale = 1) {
    std::vector<std::pair<int, std::vector<std::vector<int>>>> groups(4);
    const auto add = [&](std::size_t g, int dimension, const auto& cells) {
        groups[g].first = dimension;
        for (const auto& cell : cells) groups[g].second.emplace_back(cell.begin(), cell.end());
    };
    add(0, 3, s.mesh.fluid.nodes);
    add(1, 3, s.mesh.solid.nodes);
    add(2, 2, patchOf(s, "base").faces);
    add(3, 2, sides(s));
    std::size_t total = 0;
    for (const auto& group : groups) total += group.second.size();
    std::string text =
        version == 2 ? "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" : "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    text += "$PhysicalNames\n4\n3 1 \"water\"\n3 2 \"slab\"\n2 3 \"base\"\n2 4 \"tank\"\n$EndPhysicalNames\n";
    if (version == 4)
        text +=
            "$Entities\n0 0 2 2\n3 0 0 0 1 1 1 1 3 0\n4 0 0 0 1 1 1 1 4 0\n1 0 0 0 1 1 1 1 1 0\n2 0 0 0 1 1 1 1 2 0\n"
            "$EndEntities\n";
    const int n = s.nodes.size();
    text += version == 2 ? fmt::format("$Nodes\n{}\n", n) : fmt::format("$Nodes\n1 {0} 1 {0}\n3 1 0 {0}\n", n);
    for (int i = 0; version == 4 && i < n; ++i) text += fmt::format("{}\n", i + 1);
    for (int i = 0; i < n; ++i) {
        const Vec<3> x = scale * s.nodes.x[i];
        text += version == 2 ? fmt::format("{} {} {} {}\n", i + 1, x[0], x[1], x[2])
                             : fmt::format("{} {} {}\n", x[0], x[1], x[2]);
    }
    text += "$EndNodes\n$Elements\n";
    text += version == 2 ? fmt::format("{}\n", total) : fmt::format("4 {0} 1 {0}\n", total);
    int number = 0;
    for (std::size_t g = 0; g < 4; ++g) {
        const int type = groups[g].first == 3 ? 4 : 2;
        if (version == 4) text += fmt::format("{} {} {} {}\n", groups[g].first, g + 1, type, groups[g].second.size());
        for (const auto& cell : groups[g].second) {
            text +=
                version == 2 ? fmt::format("{} {} 2 {} {}", ++number, type, g + 1, g + 1) : fmt::format("{}", ++number);
            for (const int i : cell) text += fmt::format(" {}", i + 1);
            text += "\n";
        }
    }
    return text + "$EndElements\n";
}

SpaceDescription description(const std::string& more = "") {
    return describeSpace(
        "meshFile \"a.msh\"; " + more +
        " bodies { water { type fluid; material water; velocity (1 1 1); } plate { type solid; material "
        "rubber; group slab; patches { base { } } } } walls { tank { } }");
}

TEST(SpaceMsh, BothVersionsGiveTheSameStateAgain) {
    const Folder folder;
    for (const int version : {2, 4})
        for (const double scale : {1.0, 1000.0}) {
            const auto file = folder.write("a.msh", mshText(state(), version, scale));
            EXPECT_TRUE(holdsTetrahedra(file));
            EXPECT_EQ(meshDimension(Dictionary::parse("meshFile \"a.msh\";"), folder.path), 3);
            const auto taken = takeSpaceMesh(description(scale == 1 ? "" : "scale 0.001;"), readMeshFile<3>(file, ""));
            expectSound(taken.state);
            EXPECT_TRUE(taken.warnings.empty());
            EXPECT_EQ(taken.state.mesh.fluid.size(), state().mesh.fluid.size());
            EXPECT_EQ(taken.state.mesh.solid.size(), state().mesh.solid.size());
            EXPECT_NEAR(volumeOf(taken.state.nodes.x, taken.state.mesh.fluid), 0.5, 1e-12);
            EXPECT_NEAR(areaOf(taken.state, "base"), 1, 1e-12);
            EXPECT_NEAR(areaOf(taken.state, "tank"), 2, 1e-12);
            const auto onWalls = [](const State<3>& s) {
                return std::count_if(s.nodes.wall.begin(), s.nodes.wall.end(),
                                     [](const auto& w) { return isSupported(w); });
            };
            EXPECT_EQ(onWalls(taken.state), onWalls(state()));
            for (int i = 0; i < taken.state.nodes.size(); ++i) EXPECT_NEAR(taken.state.nodes.h[i], 0.22, 0.18);
        }
}

TEST(SpaceMsh, VtuOfATimeFolder) {
    const Folder folder;
    writeState(folder.path / "0", state());
    const auto file = readMeshFile<3>(folder.path / "0" / "fluid.vtu", "material");
    const auto taken = takeSpaceMesh(
        describeSpace(
            "meshFile \"a.vtu\"; bodies { w { type fluid; material oil; group water; } } walls { tank { geometry { "
            "type box; min (0 0 0); max (1 1 0.5); } open zMax; } }"),
        file);
    expectSound(taken.state);
    EXPECT_NEAR(areaOf(taken.state, "tank"), 3, 1e-12);
    EXPECT_EQ(taken.state.mesh.fluid.size(), state().mesh.fluid.size());
}

TEST(SpaceMsh, ErrorsNameTheLine) {
    const Folder folder;
    const std::string one =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 "
        "1\n$EndNodes\n$Elements\n"
        "2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 2 3 4 5\n$EndElements\n";
    const auto says = [&](const std::string& from, const std::string& to, int line) {
        std::string text = one;
        text.replace(text.find(from), from.size(), to);
        const auto file = folder.write("a.msh", text);
        try {
            takeSpaceMesh(describeSpace("meshFile \"a.msh\"; bodies { w { type fluid; material water; group 1; } }"),
                          readMsh<3>(file));
        } catch (const UserError& error) {
            EXPECT_EQ(error.where().line, line) << error.what();
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(says("2.2", "2.2", 0), "");
    EXPECT_NE(says("2 3 4 5", "1 2 3 5", 15).find("overlaps"), std::string::npos);
    EXPECT_NE(says("2 3 4 5", "1 2 3 3", 15).find("no volume"), std::string::npos);
    EXPECT_NE(says("2 4 2 1 1 2 3 4 5", "2 5 2 1 1 1 2 3 4 5 1 2 3", 15).find("hexahedron"), std::string::npos);
    EXPECT_NE(says("2 4 2 1 1 2 3 4 5", "2 11 2 1 1 1 2 3 4 5 1 2 3 4 5", 15).find("second order"), std::string::npos);
    EXPECT_NE(says("2 4 2 1 1 2 3 4 5", "2 4 2 1 1 2 3 4", 15).find("numbers expected"), std::string::npos);
    folder.write("a.msh", one);
    EXPECT_THROW(readMsh(folder.path / "a.msh"), UserError);  // in the plane
}

TEST(SpaceMsh, DamagedOnesAreRefusedOrTaken) {
    const Folder folder;
    const char* many = std::getenv("PFEM_MUTATIONS");
    const int n = many != nullptr ? std::atoi(many) : 100;
    std::mt19937 random(3);
    for (const int version : {2, 4}) {
        const std::string sound = mshText(state(), version);
        int refused = 0;
        for (int k = 0; k < n; ++k) {
            std::string text = sound;
            const auto at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    text.erase(at, 1 + random() % 30);
                    break;
                case 2:
                    text.resize(at);
                    break;
                default:
                    text.insert(at, text.substr(random() % text.size(), random() % 40));
            }
            folder.write("a.msh", text);
            try {
                takeSpaceMesh(description(), readMsh<3>(folder.path / "a.msh"));
            } catch (const UserError& error) {
                EXPECT_FALSE(error.where().file.empty()) << error.what();
                ++refused;
            }
        }
        EXPECT_GT(refused, n / 4);
    }
}

}  // namespace
