#pragma once
// Cases in space and what every mesh of tetrahedra must fulfil.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "mesh/simplex.hpp"
#include "mesher/space/readSpaceDict.hpp"
#include "mesher/space/spaceReport.hpp"

namespace pfem::testing {

inline SpaceDescription describeSpace(const std::string& text, const std::filesystem::path& folder = "", double h = 0) {
    return readSpaceDict(Dictionary::parse(text, "meshDict"), {"water", "oil", "rubber"}, folder, h);
}

inline SpaceMeshResult spaceMeshOf(const std::string& text, double h = 0) {
    return buildSpaceMesh(describeSpace(text, "", h));
}

/// One body of water of a shape.
inline std::string waterOf(const std::string& shape, const std::string& h) {
    return "meshSize " + h + "; bodies { water { type fluid; material water; geometry { " + shape + " } } }";
}

inline double volumeOf(const Points<3>& x, const Cells<3>& cells) {
    double sum = 0;
    for (const auto& s : cells.nodes) sum += simplexMeasure<3>(x, s);
    return sum;
}

/// Directed faces of cells with the number of their uses, the least node first.
inline std::map<Face<3>, int> directedFaces(const Cells<3>& cells) {
    std::map<Face<3>, int> faces;
    for (const auto& s : cells.nodes)
        for (int k = 0; k < 4; ++k) {
            Face<3> face = oppositeFace<3>(s, k);
            std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
            ++faces[face];
        }
    return faces;
}

inline Face<3> turned(const Face<3>& face) { return {face[0], face[2], face[1]}; }

/// Positive cells without slivers; each directed face once in all; all nodes used; points of walls in no cell; the
/// boundary of all cells is closed.
inline void expectSound(const State<3>& state) {
    std::map<Face<3>, int> faces = directedFaces(state.mesh.fluid);
    for (const auto& [face, n] : directedFaces(state.mesh.solid)) faces[face] += n;
    std::set<int> ofCells, ofWalls;
    for (const auto* cells : {&state.mesh.fluid, &state.mesh.solid}) {
        ASSERT_EQ(cells->nodes.size(), cells->material.size());
        for (const auto& s : cells->nodes) {
            EXPECT_GT(simplexMeasure<3>(state.nodes.x, s), 0);
            ofCells.insert(s.begin(), s.end());
        }
    }
    std::map<std::pair<int, int>, int> rim;  // each edge of the boundary is run through as often forwards as backwards
    for (const auto& [face, n] : faces) {
        EXPECT_EQ(n, 1);
        if (faces.count(turned(face))) continue;
        for (int k = 0; k < 3; ++k) {
            const int a = face[k], b = face[(k + 1) % 3];
            rim[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    }
    for (const auto& [edge, n] : rim) EXPECT_EQ(n, 0);
    for (const auto& patch : state.mesh.patches)
        for (const auto& face : patch.faces)
            for (const int i : face)
                if (!ofCells.count(i)) ofWalls.insert(i);
    EXPECT_EQ(static_cast<int>(ofCells.size() + ofWalls.size()), state.nodes.size());
    for (int i = 0; i < state.nodes.size(); ++i) {
        EXPECT_EQ(state.nodes.id[i], i);
        EXPECT_EQ(state.nodes.x[i], state.nodes.X[i]);
        EXPECT_GT(state.nodes.h[i], 0);
    }
    EXPECT_EQ(state.nextId, state.nodes.size());
}

/// Nearly regular: angles between faces above 10 degrees, hardly any sliver, edges as long as wanted.
inline void expectGood(const State<3>& state) {
    for (const auto* cells : {&state.mesh.fluid, &state.mesh.solid}) {
        if (cells->size() == 0) continue;
        const auto q = tetraQuality(state.nodes, *cells, 0, cells->size());
        EXPECT_GT(q.minAngle, 10);
        EXPECT_GT(q.meanMinAngle, 40);
        EXPECT_LE(q.slivers, 1 + cells->size() / 1000);
        EXPECT_NEAR(q.median, 1, 0.15);
        EXPECT_LT(q.longest, 2.3);
    }
}

inline const Patch<3>& patchOf(const State<3>& state, const std::string& name) {
    for (const auto& patch : state.mesh.patches)
        if (patch.name == name) return patch;
    throw std::runtime_error("no patch " + name);
}

inline double areaOf(const State<3>& state, const std::string& patch) {
    double sum = 0;
    for (const auto& face : patchOf(state, patch).faces) sum += faceArea<3>(state.nodes.x, face).norm();
    return sum;
}

/// Water round a pier of rubber in a tank with a plate under it of another size; a ball in the air.
inline std::string pool() {
    return "meshSize 0.1; geometry { pool { type box; min (0 0 0); max (1 0.8 0.6); } tankBox { type box; min (0 0 0); "
           "max "
           "(1 0.8 1.2); } pierBox { type box; min (0.4 0.3 0); max (0.6 0.5 0.9); } "
           "plateBox { type box; min (0 0 -0.1); max (1 0.8 0); } ball { type sphere; centre (0.5 0.4 1.3); radius "
           "0.2; } } "
           "bodies { water { type fluid; material water; geometry pool; subtract (pierBox); velocity (1 2 3); } "
           "pier { type solid; material rubber; geometry pierBox; patches { top { faces (zMax); } } } "
           "plate { type solid; material rubber; geometry plateBox; meshSize 0.07; patches { base { faces (zMin); } "
           "left { box (0 0 -0.1) (0 0.8 0); } } } "
           "drop { type fluid; material oil; geometry ball; } } "
           "walls { tank { geometry tankBox; open (zMin zMax); } }";
}

}  // namespace pfem::testing
