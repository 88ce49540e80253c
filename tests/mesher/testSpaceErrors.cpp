// What is refused of a meshDict in space, with its line; mutated surface files.

#include "spaceCases.hpp"

#include <fmt/format.h>

#include <fstream>
#include <random>

#include "io/surfaceFile.hpp"
#include "mesher/space/checkSpace.hpp"
#include "mesher/space/checkSurface.hpp"
#include "mesher/space/shapes.hpp"
#include "mshCase.hpp"

using namespace pfem;
using namespace pfem::testing;

namespace {

/// The surface as an STL of text, one solid for each region.
std::string stlText(const TriSurface& s) {
    std::string text;
    for (std::size_t r = 0; r < s.regions.size(); ++r) {
        text += "solid " + s.regions[r] + "\n";
        for (int k = 0; k < s.size(); ++k) {
            if (s.region[k] != static_cast<int>(r)) continue;
            text += "  facet normal 0 0 0\n    outer loop\n";
            for (const int i : s.triangles[k])
                text += fmt::format("      vertex {:.9g} {:.9g} {:.9g}\n", s.x[i][0], s.x[i][1], s.x[i][2]);
            text += "    endloop\n  endfacet\n";
        }
        text += "endsolid " + s.regions[r] + "\n";
    }
    return text;
}

std::string stlBytes(const TriSurface& s) {
    std::string bytes(80, ' ');
    const auto put = [&](const void* data, std::size_t n) { bytes.append(static_cast<const char*>(data), n); };
    const auto count = static_cast<std::uint32_t>(s.size());
    put(&count, 4);
    for (const auto& t : s.triangles) {
        std::array<float, 12> numbers{};
        for (int c = 0; c < 9; ++c) numbers[3 + c] = static_cast<float>(s.x[t[c / 3]][c % 3]);
        put(numbers.data(), sizeof numbers);
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string objText(const TriSurface& s) {
    std::string text = "# a box\n";
    for (const auto& x : s.x) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", x[0], x[1], x[2]);
    for (std::size_t r = 0; r < s.regions.size(); ++r) {
        text += "g " + s.regions[r] + "\n";
        for (int k = 0; k < s.size(); ++k)
            if (const auto& t = s.triangles[k]; s.region[k] == static_cast<int>(r))
                text += fmt::format("f {}/1/1 {}//2 {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
    return text;
}

std::string offText(const TriSurface& s) {
    std::string text = fmt::format("OFF\n{} {} 0\n", s.x.size(), s.size());
    for (const auto& x : s.x) text += fmt::format("{:.9g} {:.9g} {:.9g}\n", x[0], x[1], x[2]);
    for (const auto& t : s.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
    return text;
}

std::string vtpText(const TriSurface& s) {
    std::string points, corners, offsets, regions;
    for (const auto& x : s.x) points += fmt::format("{:.9g} {:.9g} {:.9g} ", x[0], x[1], x[2]);
    for (int k = 0; k < s.size(); ++k) {
        for (const int i : s.triangles[k]) corners += fmt::format("{} ", i);
        offsets += fmt::format("{} ", 3 * (k + 1));
        regions += fmt::format("{} ", s.region[k]);
    }
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n"
        "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">{}</DataArray></Points>\n"
        "<CellData><DataArray type=\"Int32\" Name=\"region\" format=\"ascii\">{}</DataArray></CellData>\n"
        "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">{}</DataArray>\n"
        "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">{}</DataArray></Polys>\n"
        "</Piece>\n</PolyData>\n</VTKFile>\n",
        s.x.size(), s.size(), points, regions, corners, offsets);
}

std::string fileBody(const std::string& name, const std::string& more = "", const std::string& h = "0.2") {
    return "meshSize " + h + "; geometry { shape { type triSurfaceMesh; file \"" + name + "\"; " + more +
           " } } bodies { water { type fluid; material water; geometry shape; } }";
}

std::string errorOf(const std::function<void()>& f, int line = -1) {
    try {
        f();
    } catch (const UserError& error) {
        if (line >= 0) {
            EXPECT_EQ(error.where().line, line) << error.what();
        }
        return error.what();
    }
    return "";
}

#define EXPECT_SAYS(text, part) EXPECT_NE(std::string(text).find(part), std::string::npos) << (text)

TEST(SpaceFiles, AllFormsGiveTheSameMesh) {
    const Folder folder;
    const TriSurface box = boxSurface({0, 0, 0}, {1, 0.75, 0.5});
    std::filesystem::create_directories(folder.path / "constant/triSurface");
    const std::pair<const char*, std::string> files[] = {{"text.stl", stlText(box)},
                                                         {"binary.stl", stlBytes(box)},
                                                         {"box.obj", objText(box)},
                                                         {"box.off", offText(box)},
                                                         {"box.vtp", vtpText(box)}};
    for (const auto& [name, content] : files) {
        folder.write(std::string("constant/triSurface/") + name, content);
        const auto description = describeSpace(fileBody(name), folder.path);
        const auto& shape = description.geometries.front();
        EXPECT_TRUE(shape.closed) << name;
        EXPECT_EQ(shape.surface.x.size(), 8u) << name;
        EXPECT_EQ(shape.surface.size(), 12) << name;
        EXPECT_DOUBLE_EQ(volumeInside(shape.surface), 0.375) << name;
        const bool one = name == std::string("binary.stl") || name == std::string("box.off");
        EXPECT_EQ(shape.surface.regions.size(), one ? 1u : 6u) << name;
        const auto state = buildSpaceMesh(description).state;
        expectSound(state);
        EXPECT_NEAR(volumeOf(state.nodes.x, state.mesh.fluid), 0.375, 1e-12) << name;
    }
    const auto split = describeSpace(fileBody("binary.stl", "includedAngle 150; scale 0.001;", "0.0002"), folder.path);
    EXPECT_EQ(split.geometries.front().surface.regions.size(), 6u);
    EXPECT_NEAR(volumeInside(split.geometries.front().surface), 0.375e-9, 1e-20);
}

TEST(SpaceFiles, TurnedTrianglesAreTurnedBack) {
    const Folder folder;
    TriSurface box = boxSurface({0, 0, 0}, {1, 1, 1});
    for (const int k : {0, 3, 4, 8}) std::swap(box.triangles[k][1], box.triangles[k][2]);
    const auto file = folder.write("box.stl", stlText(box)).string();
    EXPECT_DOUBLE_EQ(volumeInside(describeSpace(fileBody("box.stl"), folder.path).geometries.front().surface), 1);
}

TEST(SpaceErrors, OfSurfacesNameThePlace) {
    const Folder folder;
    const TriSurface box = boxSurface({0, 0, 0}, {1, 1, 1});
    const auto says = [&](TriSurface s, double scale = 1) {
        for (auto& x : s.x) x *= scale;
        folder.write("a.stl", stlText(s));
        return errorOf([&] { buildSpaceMesh(describeSpace(fileBody("a.stl"), folder.path)); });
    };
    TriSurface open = box;
    open.triangles.pop_back();
    open.region.pop_back();
    EXPECT_SAYS(says(open), "is not closed: body 'water' would leak. 3 edges");
    EXPECT_SAYS(says(open), "(0 0 1)");
    TriSurface crossing = box;
    const TriSurface other = boxSurface({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
    for (const auto& t : other.triangles) crossing.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    crossing.region.resize(24, 0);
    crossing.x.insert(crossing.x.end(), other.x.begin(), other.x.end());
    EXPECT_SAYS(says(crossing), "crosses or touches itself: the triangles (");
    TriSurface three = box;
    three.x.push_back({0.5, 0.5, 2});
    three.triangles.push_back({4, 5, 8});
    three.region.push_back(0);
    EXPECT_SAYS(says(three), "has an edge of 3 triangles, from (");
    EXPECT_SAYS(says(box, 1000), "Check meshSize and the units");
    folder.write("a.stl", stlText(boxSurface({0, 0, 0}, {1000, 1000, 1000})));
    const auto description = describeSpace(fileBody("a.stl", "", "300"), folder.path);
    EXPECT_SAYS(buildSpaceMesh(description).warnings.front(), "in millimetres (scale 0.001;)?");
}

TEST(SpaceErrors, OfTheDictionaryNameTheLine) {
    const std::string head = "meshSize 0.2;\ngeometry { a { type box; min (0 0 0); max (1 1 1); } }\n";
    const auto says = [&](const std::string& text, int line) {
        return errorOf([&] { buildSpaceMesh(describeSpace(text)); }, line);
    };
    const std::string body = "type fluid; material water; geometry a;";
    EXPECT_EQ(says(head + "bodies { w { " + body + " } }", 0), "");
    EXPECT_SAYS(says("geometry { a {\n type boks; } } bodies { }", 2), "box");
    EXPECT_SAYS(says(head + "bodies { w { type fluid; material water;\n geometry b; } }", 4), "Unknown geometry b");
    EXPECT_SAYS(says(head + "bodies { w { " + body + "\n patches { p {\n faces (xmin); } } } }", 5), "xMin");
    EXPECT_SAYS(says(head + "bodies { w { " + body + " } } walls { t { geometry a;\n open (top); } }", 4), "zMax");
    EXPECT_SAYS(says(head + "bodies { w { " + body + "\n meshSize 3; } }", 4), "larger than body 'w'");
    EXPECT_SAYS(says(head + "bodies { w { " + body + " } v { " + body + " } }", 3), "'w' and 'v' lie in each other");
    EXPECT_SAYS(says(head + "bodies { w { " + body + " subtract a; } }", 3), "Nothing is left of body 'w'");
    EXPECT_SAYS(says(head + "bodies { w { " + body + "\n vertices ((0 0)); } }", 4), "type extrude");
    EXPECT_SAYS(
        says(head + "bodies { w { " + body + " patches { t { faces xMin; } } } } walls { t { geometry a; } }", 3),
        "the name of a wall");
    EXPECT_SAYS(
        says("meshSize 1; bodies { w { type fluid; material water; geometry {\n type box; min (0 0 0);\n max (1 0 1); "
             "} } }",
             3),
        "above 'min'");
    EXPECT_SAYS(
        says("meshSize 1; bodies { w { type fluid; material water; geometry { type extrude; height 1;\n vertices "
             "((0 0) (0 1) (1 1)); } } }",
             2),
        "clockwise");
    EXPECT_SAYS(
        says("meshSize 1; bodies { w { type fluid; material water; geometry { type extrude; height 1;\n vertices "
             "((0 0) (2 2) (2 0) (0 3)); } } }",
             2),
        "");
    EXPECT_SAYS(
        says("meshSize 1; bodies { w { type fluid; material water;\n geometry { type disk; origin (0 0 0); normal (0 0 "
             "1); radius 5; } } }",
             2),
        "not closed");
    EXPECT_THROW(meshDimension(Dictionary::parse("dimension 4;"), ""), UserError);
    EXPECT_EQ(meshDimension(Dictionary::parse("bodies { a { geometry b; } }"), ""), 3);
    EXPECT_EQ(meshDimension(Dictionary::parse("bodies { a { vertices (); } }"), ""), 2);
}

TEST(SpaceErrors, GapsAreClosedOrRefused) {
    const auto at = [&](const std::string& z) {
        return spaceMeshOf(
                   "meshSize 0.1; geometry { w { type box; min (0 0 " + z +
                   "); max (1 1 0.5); } p { type box; min (0 0 -0.3); max (1 1 0); } } bodies { water { type fluid; "
                   "material water; geometry w; } plate { type solid; material rubber; geometry p; } }")
            .state;
    };
    for (const char* z : {"0", "1e-16", "-1e-9", "5e-6"}) {
        const auto state = at(z);
        expectSound(state);
        EXPECT_NEAR(volumeOf(state.nodes.x, state.mesh.fluid), 0.5, 1e-5);
        double common = 0;
        const auto solid = directedFaces(state.mesh.solid);
        for (const auto& [face, n] : directedFaces(state.mesh.fluid))
            if (solid.count(turned(face))) common += faceArea<3>(state.nodes.x, face).norm();
        EXPECT_NEAR(common, 1, 1e-12) << z;
    }
    for (const char* z : {"2e-5", "1e-3", "9e-3", "-1e-3"})
        EXPECT_SAYS(errorOf([&] { at(z); }), "'w' and 'p' run along each other");
    expectSound(at("0.02"));
    // round shapes with the same facets touch; a pier in a round tank
    expectSound(
        spaceMeshOf(
            "meshSize 0.1; geometry { a { type cylinder; point1 (0 0 0); point2 (0 0 0.4); radius 0.5; } t { "
            "type cylinder; point1 (0 0 0); point2 (0 0 1); radius 0.5; } p { type cylinder; point1 (0.1 0 0); "
            "point2 (0.1 0 0.6); radius 0.15; } } bodies { w { type fluid; material water; geometry a; subtract "
            "p; } p { type solid; material rubber; geometry p; } } walls { t { geometry t; open end2; } }")
            .state);
}

/// A byte changed, a piece left out or doubled, the end cut off.
std::string damaged(std::string text, std::mt19937& random) {
    const auto at = [&] { return random() % text.size(); };
    switch (random() % 5) {
        case 0:
            text[at()] = static_cast<char>(random() % 256);
            break;
        case 1:
            text.erase(at(), 1 + random() % 20);
            break;
        case 2:
            text.insert(at(), text.substr(at(), random() % 60));
            break;
        case 3:
            text.resize(at());
            break;
        default: {
            const auto digit = text.find_first_of("0123456789", at());
            if (digit != std::string::npos) text[digit] = static_cast<char>('0' + random() % 10);
        }
    }
    return text;
}

TEST(SpaceFiles, DamagedOnesAreRefusedOrMeshed) {
    const Folder folder;
    std::mt19937 random(7);
    const TriSurface shape = coneSurface({0, 0, 0}, 0.5, {0, 0, 1}, 0.3, 8);
    const char* many = std::getenv("PFEM_MUTATIONS");
    const int n = many != nullptr ? std::atoi(many) : 100;
    const std::pair<const char*, std::string> files[] = {{"a.stl", stlText(shape)},
                                                         {"b.stl", stlBytes(shape)},
                                                         {"a.obj", objText(shape)},
                                                         {"a.off", offText(shape)},
                                                         {"a.vtp", vtpText(shape)}};
    for (const auto& [name, content] : files) {
        int refused = 0;
        for (int k = 0; k < n; ++k) {
            std::string text = damaged(content, random);
            for (int more = static_cast<int>(random() % 3); more > 0 && !text.empty(); --more)
                text = damaged(text, random);
            folder.write(name, text);
            try {
                const auto description = describeSpace(fileBody(name, "", "0.25"), folder.path);
                if (k % 4 == 0)
                    buildSpaceMesh(description);
                else
                    checkSpace(description);
            } catch (const UserError& error) {
                EXPECT_GT(std::string(error.what()).size(), 10u);
                EXPECT_FALSE(error.where().file.empty());
                ++refused;
            }
        }
        EXPECT_GT(refused, n / 4) << name;
    }
}

}  // namespace
