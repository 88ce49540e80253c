#include "mesh/checkMesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mesh/bins.hpp"
#include "mesh/components.hpp"
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

/// 3 r/R with r = 3 V / (sum of the faces) and R = |a^2 (b x c) + b^2 (c x a) + c^2 (a x b)| / (12 V).
double quality(const Points<3>& x, const Simplex<3>& s) {
    const Vec<3> a = x[s[1]] - x[s[0]], b = x[s[2]] - x[s[0]], c = x[s[3]] - x[s[0]];
    const double volume = std::abs(simplexMeasure<3>(x, s));
    double faces = 0;
    for (int k = 0; k < 4; ++k) faces += faceArea<3>(x, oppositeFace<3>(s, k)).norm();
    const double twelveVR =
        (a.squaredNorm() * b.cross(c) + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)).norm();
    return faces * twelveVR > 0 ? 108 * volume * volume / (faces * twelveVR) : 0;
}

template <int Dim>
CellShapes shapesOf(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells, std::vector<MeshFault<Dim>>& faults) {
    CellShapes shapes;
    for (int e = 0; e < static_cast<int>(cells.size()); ++e) {
        const double q = quality(x, cells[e]);
        ++shapes.histogram[static_cast<std::size_t>(std::clamp(static_cast<int>(10 * q), 0, 9))];
        if (shapes.worstCell < 0 || q < shapes.worst) shapes.worst = q, shapes.worstCell = e;
        if (simplexMeasure<Dim>(x, cells[e]) > 0) continue;
        ++shapes.inverted;
        faults.push_back({Dim == 2 ? "inverted triangle" : "inverted tetrahedron", simplexCentroid<Dim>(x, cells[e])});
    }
    return shapes;
}

template <int Dim>
void findCrowdedFaces(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells,
                      std::vector<MeshFault<Dim>>& faults) {
    std::map<Face<Dim>, int> count;
    for (const auto& s : cells)
        for (int k = 0; k <= Dim; ++k) {
            Face<Dim> face = oppositeFace<Dim>(s, k);
            std::sort(face.begin(), face.end());
            ++count[face];
        }
    for (const auto& [face, n] : count) {
        if (n <= 2) continue;
        Vec<Dim> middle = Vec<Dim>::Zero();
        for (const int i : face) middle += x[i] / Dim;
        faults.push_back({Dim == 2 ? "edge of more than two triangles" : "face of more than two tetrahedra", middle});
    }
}

template <int Dim>
void findTwins(const Mesh<Dim>& mesh, const Topology<Dim>& topology, const Points<Dim>& x, const std::vector<double>& h,
               std::vector<MeshFault<Dim>>& faults) {
    std::set<int> used;
    for (const auto* cells : {&mesh.fluid, &mesh.solid})
        for (const auto& s : cells->nodes) used.insert(s.begin(), s.end());
    std::vector<int> nodes(used.begin(), used.end());
    std::erase_if(nodes, [&](int i) { return topology.isUnderSkin(i); });
    std::sort(nodes.begin(), nodes.end(), [&](int i, int j) { return x[i][0] < x[j][0]; });
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double near = 1e-3 * h[nodes[i]];
        for (std::size_t j = i + 1; j < nodes.size() && x[nodes[j]][0] - x[nodes[i]][0] < near; ++j)
            if ((x[nodes[j]] - x[nodes[i]]).norm() < near)
                faults.push_back({"two nodes at one place: bodies that touch must share their nodes", x[nodes[i]]});
    }
}

/// Faces of walls and of solids.
template <int Dim>
std::vector<Face<Dim>> obstacles(const Topology<Dim>& topology) {
    std::vector<Face<Dim>> faces;
    for (const auto& wall : topology.walls)
        if (wall.patch >= 0) faces.push_back(wall.nodes);
    for (const auto& face : topology.solidFaces) faces.push_back(face.nodes);
    return faces;
}

template <int Dim>
void findGaps(const Mesh<Dim>& mesh, const Topology<Dim>& topology, const Points<Dim>& x, const std::vector<double>& h,
              std::vector<MeshFault<Dim>>& gaps) {
    const auto solid = obstacles<Dim>(topology);
    double size = 0;
    for (const double one : h) size = std::max(size, one);
    Bins<Dim> bins(x, 2 * size);
    for (std::size_t k = 0; k < solid.size(); ++k) {
        Vec<Dim> low = x[solid[k][0]], high = low;
        for (const int i : solid[k]) low = low.cwiseMin(x[i]).eval(), high = high.cwiseMax(x[i]).eval();
        bins.add(static_cast<int>(k), low, high);
    }
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        Vec<Dim> middle = Vec<Dim>::Zero(), low = x[face.nodes[0]], high = low;
        for (const int i : face.nodes) {
            middle += x[i] / Dim;
            low = low.cwiseMin(x[i] - Vec<Dim>::Constant(0.1 * h[i])).eval();
            high = high.cwiseMax(x[i] + Vec<Dim>::Constant(0.1 * h[i])).eval();
        }
        const bool gap = bins.any(low, high, [&](int k) {
            return std::all_of(face.nodes.begin(), face.nodes.end(),
                               [&](int i) { return distanceToFace<Dim>(x, solid[k], x[i]) < 0.1 * h[i]; });
        });
        if (gap) gaps.push_back({"free surface along a wall or solid: a gap, or nodes that are not shared", middle});
    }
}

/// Pieces of free surface that share nodes.
template <int Dim>
int countPieces(const std::vector<FluidFace<Dim>>& faces, int nNodes) {
    std::vector<Face<Dim>> surface;
    for (const auto& face : faces)
        if (face.kind == FaceKind::freeSurface) surface.push_back(face.nodes);
    const auto root = components(surface, nNodes);
    std::set<int> pieces;
    for (const auto& face : surface) pieces.insert(root[face[0]]);
    return static_cast<int>(pieces.size());
}

}  // namespace

template <int Dim>
MeshCheck<Dim> checkMesh(const Mesh<Dim>& mesh, const Topology<Dim>& topology, const Points<Dim>& x,
                         const std::vector<double>& h) {
    MeshCheck<Dim> check;
    check.fluid = shapesOf<Dim>(x, mesh.fluid.nodes, check.faults);
    check.solid = shapesOf<Dim>(x, mesh.solid.nodes, check.faults);
    findCrowdedFaces<Dim>(x, mesh.fluid.nodes, check.faults);
    findCrowdedFaces<Dim>(x, mesh.solid.nodes, check.faults);
    findTwins<Dim>(mesh, topology, x, h, check.faults);
    findGaps<Dim>(mesh, topology, x, h, check.gaps);
    for (const auto& face : topology.faces) {
        const double measure = faceArea<Dim>(x, face.nodes).norm();
        (face.kind == FaceKind::freeSurface ? check.freeSurface
         : face.kind == FaceKind::wall      ? check.wetWalls
                                            : check.interface) += measure;
    }
    check.pieces = countPieces<Dim>(topology.faces, topology.nNodes());
    return check;
}

#define PFEM_INSTANTIATE(D)                                                                  \
    template MeshCheck<D> checkMesh<D>(const Mesh<D>&, const Topology<D>&, const Points<D>&, \
                                       const std::vector<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
