#pragma once
// Geometries of the standard cases and what every mesh must fulfil.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "mesher/meshReport.hpp"
#include "mesher/readMeshDict.hpp"

namespace pfem::testing {

inline MeshDescription describe(const std::string& text, double h = 0) {
    return readMeshDict(Dictionary::parse(text, "meshDict"), {"water", "oil", "rubber"}, h);
}

inline MeshResult meshOf(const std::string& text, double h = 0) { return buildMesh(describe(text, h)); }

inline std::string fluidBody(const std::string& name, const std::string& vertices, const std::string& more = "") {
    return name + " { type fluid; material water; vertices (" + vertices + "); " + more + " }\n";
}

inline std::string solidBody(const std::string& name, const std::string& vertices, const std::string& more = "") {
    return name + " { type solid; material rubber; vertices (" + vertices + "); " + more + " }\n";
}

inline std::string dictOf(const std::string& bodies, const std::string& walls = "", const std::string& h = "0.1") {
    return "meshSize " + h + ";\nbodies\n{\n" + bodies + "}\nwalls\n{\n" + walls + "}\n";
}

inline std::string damBreakElasticWall() {
    return dictOf(fluidBody("water", "(0 0) (0.146 0) (0.146 0.292) (0 0.292)") +
                      solidBody("wall", "(0.292 0) (0.304 0) (0.304 0.08) (0.292 0.08)",
                                "patches { wallBase { edges ((0 1)); } }"),
                  "tank { points ((0 0.6) (0 0) (0.596 0) (0.596 0.6)); }", "0.003");
}

inline std::string wedge() {
    return dictOf(fluidBody("water", "(0 0) (2.5 0) (2.5 1.1) (0 1.1)") +
                      solidBody("wedge", "(1.25 2.4) (1.85 2.67978) (0.65 2.67978)", "velocity (0 -1 0);"),
                  "basin { points ((0 3) (0 0) (2.5 0) (2.5 3)); }", "0.0075");
}

/// Oblique walls, a curved elastic container that touches them at points.
inline std::string elasticContainer() {
    return dictOf(fluidBody("water", "(-0.65 0) (0.65 0) (2.4357 2.5) (-2.4357 2.5)") +
                      solidBody("shell",
                                "(-2.45 0) (-2.45 -3.75) (2.45 -3.75) (2.45 0) (2.25 0) (2.25 -3.75) (-2.25 -3.75) "
                                "(-2.25 0)",
                                "meshSize 0.05; edges (arc 1 2 (0 -6.2) arc 5 6 (0 -6.0)); "
                                "patches { clamp { edges ((7 0) (3 4)); } }"),
                  "left { points ((-2.4357 2.5) (-0.65 0) (-2.25 0)); }\n"
                  "right { points ((2.25 0) (0.65 0) (2.4357 2.5)); }");
}

/// Water of another size on a plate whose vertices lie elsewhere.
inline std::string hydrostaticPlate() {
    return dictOf(fluidBody("water", "(0 0) (1 0) (1 2) (0 2)", "meshSize 0.05;") +
                      solidBody("plate", "(-0.1 -0.05) (1.1 -0.05) (1.1 0) (-0.1 0)", "meshSize 0.0125;"),
                  "left { points ((0 2.5) (0 0)); }\nright { points ((1 0) (1 2.5)); }");
}

/// A round solid inside the water of a closed box.
inline std::string cylinder() {
    return dictOf(
        fluidBody("water", "(0 0) (1 0) (1 1) (0 1)", "holes (cylinder);") +
            solidBody("cylinder", "(0.4 0.5) (0.6 0.5)", "meshSize 0.01; edges (arc 0 1 (0.5 0.4) arc 1 0 (0.5 0.6));"),
        "box { closed yes; points ((0 0) (1 0) (1 1.2) (0 1.2)); }", "0.02");
}

inline double signedArea(const State<2>& s, const Simplex<2>& t) {
    const Vec<2> u = s.nodes.x[t[1]] - s.nodes.x[t[0]], w = s.nodes.x[t[2]] - s.nodes.x[t[0]];
    return 0.5 * (u.x() * w.y() - u.y() * w.x());
}

/// Directed edges of cells with the number of their uses.
inline std::map<Face<2>, int> directedEdges(const Cells<2>& cells) {
    std::map<Face<2>, int> edges;
    for (const auto& t : cells.nodes)
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    return edges;
}

/// Positive cells; each directed edge once in all (so no overlap of cells and no hanging node); all nodes
/// used; wall faces have a fluid cell or nothing on their left and nothing on their right.
inline void expectSound(const State<2>& state) {
    std::map<Face<2>, int> edges = directedEdges(state.mesh.fluid);
    for (const auto& [edge, n] : directedEdges(state.mesh.solid)) edges[edge] += n;
    std::set<int> used;
    for (const auto* cells : {&state.mesh.fluid, &state.mesh.solid}) {
        ASSERT_EQ(cells->nodes.size(), cells->material.size());
        for (const auto& t : cells->nodes) {
            EXPECT_GT(signedArea(state, t), 0);
            used.insert(t.begin(), t.end());
        }
    }
    for (const auto& [edge, n] : edges) EXPECT_EQ(n, 1);
    for (const auto& patch : state.mesh.patches)
        for (const auto& face : patch.faces) {
            EXPECT_EQ(edges.count({face[1], face[0]}), 0u) << patch.name << ": a cell on the right of a face";
            used.insert(face.begin(), face.end());
        }
    EXPECT_EQ(static_cast<int>(used.size()), state.nodes.size());
    // boundary edges of the union must not have a node of the mesh inside
    std::vector<int> boundaryNodes;
    for (const auto& [edge, n] : edges)
        if (!edges.count({edge[1], edge[0]})) boundaryNodes.push_back(edge[0]);
    for (const auto& [edge, n] : edges) {
        if (edges.count({edge[1], edge[0]})) continue;
        const Vec<2> a = state.nodes.x[edge[0]], d = state.nodes.x[edge[1]] - a;
        for (const int i : boundaryNodes) {
            if (i == edge[0] || i == edge[1]) continue;
            const Vec<2> r = state.nodes.x[i] - a;
            const double s = r.dot(d) / d.squaredNorm();
            const bool hanging = s > 0 && s < 1 && std::abs(r.x() * d.y() - r.y() * d.x()) < 1e-9 * d.squaredNorm();
            EXPECT_FALSE(hanging);
        }
    }
    for (int i = 0; i < state.nodes.size(); ++i) {
        EXPECT_EQ(state.nodes.id[i], i);
        EXPECT_EQ(state.nodes.x[i], state.nodes.X[i]);
        EXPECT_GT(state.nodes.h[i], 0);
    }
    EXPECT_EQ(state.nextId, state.nodes.size());
}

inline const Patch<2>& patchOf(const State<2>& state, const std::string& name) {
    for (const auto& patch : state.mesh.patches)
        if (patch.name == name) return patch;
    throw std::runtime_error("no patch " + name);
}

inline double lengthOf(const State<2>& state, const std::string& patch) {
    double sum = 0;
    for (const auto& [a, b] : patchOf(state, patch).faces) sum += (state.nodes.x[a] - state.nodes.x[b]).norm();
    return sum;
}

}  // namespace pfem::testing
