#include "mesh/checkMesh.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "mesh/distance.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// 2 r/R = 16 A^2 / (abc (a + b + c)) with the sides a, b, c.
double quality(const Points<2>& x, const Simplex<2>& s) {
    const double a = (x[s[1]] - x[s[0]]).norm(), b = (x[s[2]] - x[s[1]]).norm(), c = (x[s[0]] - x[s[2]]).norm();
    const double area = simplexMeasure<2>(x, s);
    return a * b * c > 0 ? 16 * area * area / (a * b * c * (a + b + c)) : 0;
}

CellShapes shapesOf(const Points<2>& x, const std::vector<Simplex<2>>& cells, std::vector<MeshFault>& faults) {
    CellShapes shapes;
    for (int e = 0; e < static_cast<int>(cells.size()); ++e) {
        const double q = quality(x, cells[e]);
        ++shapes.histogram[static_cast<std::size_t>(std::clamp(static_cast<int>(10 * q), 0, 9))];
        if (shapes.worstCell < 0 || q < shapes.worst) shapes.worst = q, shapes.worstCell = e;
        if (simplexMeasure<2>(x, cells[e]) > 0) continue;
        ++shapes.inverted;
        faults.push_back({"inverted triangle", simplexCentroid<2>(x, cells[e])});
    }
    return shapes;
}

void findCrowdedEdges(const Points<2>& x, const std::vector<Simplex<2>>& cells, std::vector<MeshFault>& faults) {
    std::map<std::pair<int, int>, int> count;
    for (const auto& s : cells)
        for (std::size_t k = 0; k < 3; ++k) ++count[std::minmax(s[k], s[(k + 1) % 3])];
    for (const auto& [edge, n] : count)
        if (n > 2) faults.push_back({"edge of more than two triangles", 0.5 * (x[edge.first] + x[edge.second])});
}

void findTwins(const Mesh<2>& mesh, const Points<2>& x, const std::vector<double>& h, std::vector<MeshFault>& faults) {
    std::set<int> used;
    for (const auto* cells : {&mesh.fluid, &mesh.solid})
        for (const auto& s : cells->nodes) used.insert(s.begin(), s.end());
    std::vector<int> nodes(used.begin(), used.end());
    std::sort(nodes.begin(), nodes.end(), [&](int i, int j) { return x[i][0] < x[j][0]; });
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double near = 1e-3 * h[nodes[i]];
        for (std::size_t j = i + 1; j < nodes.size() && x[nodes[j]][0] - x[nodes[i]][0] < near; ++j)
            if ((x[nodes[j]] - x[nodes[i]]).norm() < near)
                faults.push_back({"two nodes at one place: bodies that touch must share their nodes", x[nodes[i]]});
    }
}

void findGaps(const Mesh<2>& mesh, const Topology<2>& topology, const Points<2>& x, const std::vector<double>& h,
              std::vector<MeshFault>& gaps) {
    std::vector<Face<2>> solid;
    for (const auto& wall : topology.walls)
        if (wall.patch >= 0) solid.push_back(wall.nodes);
    for (const auto& face : boundaryFaces<2>(mesh.solid.nodes, topology.solid)) solid.push_back(face.nodes);
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const auto [i, j] = face.nodes;
        const bool gap = std::any_of(solid.begin(), solid.end(), [&](const Face<2>& other) {
            return distanceToFace<2>(x, other, x[i]) < 0.1 * h[i] && distanceToFace<2>(x, other, x[j]) < 0.1 * h[j];
        });
        if (gap)
            gaps.push_back(
                {"free surface along a wall or solid: a gap, or nodes that are not shared", 0.5 * (x[i] + x[j])});
    }
}

/// Pieces of free surface that share nodes.
int countPieces(const std::vector<FluidFace<2>>& faces) {
    std::map<int, int> parent;
    const auto root = [&](int i) {
        while (parent.emplace(i, i).first->second != i) i = parent[i];
        return i;
    };
    for (const auto& face : faces)
        if (face.kind == FaceKind::freeSurface) parent[root(face.nodes[1])] = root(face.nodes[0]);
    return static_cast<int>(
        std::count_if(parent.begin(), parent.end(), [](const auto& p) { return p.first == p.second; }));
}

}  // namespace

MeshCheck checkMesh(const Mesh<2>& mesh, const Topology<2>& topology, const Points<2>& x,
                    const std::vector<double>& h) {
    MeshCheck check;
    check.fluid = shapesOf(x, mesh.fluid.nodes, check.faults);
    check.solid = shapesOf(x, mesh.solid.nodes, check.faults);
    findCrowdedEdges(x, mesh.fluid.nodes, check.faults);
    findCrowdedEdges(x, mesh.solid.nodes, check.faults);
    findTwins(mesh, x, h, check.faults);
    findGaps(mesh, topology, x, h, check.gaps);
    for (const auto& face : topology.faces) {
        const double length = faceArea<2>(x, face.nodes).norm();
        (face.kind == FaceKind::freeSurface ? check.freeSurface
         : face.kind == FaceKind::wall      ? check.wetWalls
                                            : check.interface) += length;
    }
    check.pieces = countPieces(topology.faces);
    return check;
}

}  // namespace pfem
