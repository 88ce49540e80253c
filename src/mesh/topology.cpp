#include "mesh/topology.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/parallel.hpp"
#include "mesh/contacts.hpp"
#include "mesh/distance.hpp"
#include "mesh/nearestOnFace.hpp"
#include "mesh/sharedTopology.hpp"
#include "mesh/simplex.hpp"
#include "mesh/sortedFace.hpp"
#include "mesh/wallBins.hpp"
#include "mesh/wallUnder.hpp"

namespace pfem {

namespace {

constexpr double touching = 1e-6;  // of a face's size

/// Each with its nodes ascending, the faces too.
template <int Dim>
std::vector<Face<Dim>> inOrder(const std::vector<BoundaryFace<Dim>>& faces) {
    std::vector<Face<Dim>> result;
    for (const auto& face : faces) result.push_back(sorted<Dim>(face.nodes));
    std::sort(result.begin(), result.end());
    return result;
}

template <int Dim>
std::set<Face<Dim>> symmetryFaces(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds) {
    std::set<Face<Dim>> faces;
    for (std::size_t n = 0; n < mesh.patches.size(); ++n)
        if (kinds[n] == PatchKind::symmetry)
            for (const auto& face : mesh.patches[n].faces) faces.insert(sorted<Dim>(face));
    return faces;
}

/// Normals of the symmetry patches that nodes of solids lie on.
template <int Dim>
std::map<int, std::vector<Vec<Dim>>> symmetryNormals(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds,
                                                     const Points<Dim>& x, const NodeToCells& solid) {
    std::map<int, std::vector<Vec<Dim>>> normals;
    for (std::size_t n = 0; n < mesh.patches.size(); ++n)
        if (kinds[n] == PatchKind::symmetry)
            for (const auto& face : mesh.patches[n].faces)
                for (const int node : face)
                    if (solid.count(node) > 0) normals[node].push_back(faceArea<Dim>(x, face).normalized());
    return normals;
}

/// Walls that a solid's node on a plane of symmetry goes on to touch beyond their ends, up to `size`: there the solid's
/// edge slides to and fro.
template <int Dim>
void findContinued(int node, const std::vector<Vec<Dim>>& planes, const Points<Dim>& x, double size, Topology<Dim>& t) {
    for (int w = 0; w < static_cast<int>(t.walls.size()); ++w) {
        const auto& wall = t.walls[w];
        if (wall.patch < 0) continue;
        const Vec<Dim> n = inwardNormal<Dim>(x, wall.nodes);
        const bool along = std::abs(n.dot(x[node] - x[wall.nodes[0]])) <= 1e-6 * size &&
                           std::any_of(planes.begin(), planes.end(),
                                       [&](const Vec<Dim>& own) { return std::abs(own.dot(n)) > 1 - 1e-6; });
        if (!along || distanceToFace<Dim>(x, wall.nodes, x[node]) > size) continue;
        if (!isOnRegion<Dim>(t.walls, t.supports[node], wall.region)) addSupport(t.supports[node], w);
    }
}

/// Walls that the nodes of solids' faces touch, to `reach` of the face's size.
template <int Dim>
void findTouching(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x, double reach,
                  Topology<Dim>& t) {
    if (mesh.solid.nodes.empty()) return;
    const auto planes = symmetryNormals<Dim>(mesh, kinds, x, t.solid);
    const WallBins<Dim> walls(t.walls, x);
    const auto sizeOf = [&](const BoundaryFace<Dim>& face) { return (x[face.nodes[1]] - x[face.nodes[0]]).norm(); };
    std::vector<double> largest(t.nNodes(), 0.0);
    for (const auto& face : t.solidFaces)
        for (const int node : face.nodes) largest[node] = std::max(largest[node], sizeOf(face));
    std::vector<unsigned char> mayTouch(t.nNodes(), 0);
    parallelFor(t.nNodes(), [&](int i) {
        mayTouch[i] = largest[i] > 0 && isSupported(walls.supportsAt(x[i], reach * largest[i]));
    });
    for (const auto& face : t.solidFaces) {
        const double size = sizeOf(face);
        for (const int node : face.nodes) {
            if (isSupported(t.supports[node])) continue;
            if (mayTouch[node]) t.supports[node] = walls.supportsAt(x[node], reach * size);
            if (const auto found = planes.find(node); found != planes.end())
                findContinued<Dim>(node, found->second, x, size, t);
        }
    }
}

/// Which nodes of solids are under skins: those without a face of their own in the fluid.
template <int Dim>
void findUnderSkins(Topology<Dim>& t) {
    std::set<Face<Dim>> skins;
    for (const auto& wall : t.walls)
        if (wall.patch >= 0 && t.kinds[wall.patch] == PatchKind::skin) skins.insert(sorted<Dim>(wall.nodes));
    if (skins.empty()) return;
    for (const auto& face : skins)
        for (const int node : face) t.wallPoint[node] = 1;
    for (const auto& face : t.solidFaces) {
        if (skins.count(sorted<Dim>(face.nodes)) > 0 || t.liesOnWall(face.nodes)) continue;
        for (const int node : face.nodes) t.wallPoint[node] = 0;
    }
}

/// On skins nodes of the fluid ride; those of the solid under them are geometry.
template <int Dim>
void setSkins(const Points<Dim>& x, Topology<Dim>& t) {
    t.rides.clear();
    if (std::find(t.kinds.begin(), t.kinds.end(), PatchKind::skin) == t.kinds.end()) return;
    findUnderSkins<Dim>(t);
    for (int i = 0; i < t.nNodes(); ++i)
        for (const int wall : Supports<Dim>(t.supports[i])) {
            if (wall < 0 || !t.isSkin(wall)) continue;
            const Face<Dim>& face = t.walls[wall].nodes;
            if (t.onWall[i])
                t.rides.push_back({i, wall, face, nearestWeights<Dim>(x, face, x[i])});
            else if (t.isUnderSkin(i))
                dropSupport(t.supports[i], wall);
        }
}

/// The face of a skin under a face of the fluid whose nodes all ride on its region, -1: none. Edges of solids meet
/// others within a few cells: a node there rides on both.
template <int Dim>
int skinUnder(const Topology<Dim>& t, const Points<Dim>& x, const Face<Dim>& face) {
    const Vec<Dim> own = faceArea<Dim>(x, face).normalized();
    for (const int wall : t.supports[face[0]]) {
        if (wall < 0 || !t.isSkin(wall)) continue;
        const bool all = std::all_of(face.begin(), face.end(), [&](int node) {
            return std::any_of(t.supports[node].begin(), t.supports[node].end(), [&](int other) {
                return other >= 0 && t.walls[other].region == t.walls[wall].region &&
                       own.dot(inwardNormal<Dim>(x, t.walls[other].nodes)) < -0.5;
            });
        });
        if (all) return wall;
    }
    return -1;
}

/// What depends on the walls that hold nodes; interfaces are known.
template <int Dim>
void setWalls(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
              const std::vector<Supports<Dim>>& wall, double reach, Topology<Dim>& t) {
    t.supports = wall;
    for (int i = 0; i < t.nNodes(); ++i) {
        t.onWall[i] = isSupported(wall[i]) && t.ofFluid(i);
        if (!t.onWall[i]) t.supports[i] = unsupported<Dim>();
    }
    findTouching<Dim>(mesh, kinds, x, reach, t);
    setSkins<Dim>(x, t);
    const auto symmetry = symmetryFaces<Dim>(mesh, kinds);
    parallelFor(static_cast<int>(t.faces.size()), [&](int f) {
        auto& face = t.faces[f];
        if (face.kind == FaceKind::interface) return;
        const bool onSymmetry = !symmetry.empty() && symmetry.count(sorted<Dim>(face.nodes)) > 0;
        face.wall = onSymmetry || t.rides.empty() ? -1 : skinUnder<Dim>(t, x, face.nodes);
        if (face.wall < 0 && !onSymmetry) {
            const Vec<Dim> outward = faceArea<Dim>(x, face.nodes).normalized();
            const auto supports = [&](int node) -> const Supports<Dim>& { return t.supports[node]; };
            face.wall = wallUnder<Dim>(t, x, face.nodes, outward, supports);
            const auto common = face.wall < 0 ? commonWalls<Dim>(t, face.nodes) : unsupported<Dim>();
            if (isAlongEdge<Dim>(x, face.nodes, common)) face.wall = common[0];
        }
        face.kind = onSymmetry || face.wall >= 0 ? FaceKind::wall : FaceKind::freeSurface;
    });
    t.freeSurface.assign(t.nNodes(), 0);
    for (const auto& face : t.faces)
        if (face.kind == FaceKind::freeSurface)
            for (int node : face.nodes) t.freeSurface[node] = 1;
}

}  // namespace

template <int Dim>
Topology<Dim> makeTopology(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                           const std::vector<Supports<Dim>>& wall, const Ranks& ranks) {
    const int nNodes = static_cast<int>(wall.size());
    Topology<Dim> t;
    t.kinds = kinds;
    t.fluid = nodeToCells<Dim>(mesh.fluid.nodes, nNodes);
    t.solid = nodeToCells<Dim>(mesh.solid.nodes, nNodes);
    auto [ring, boundary] = surroundings<Dim>(mesh.fluid.nodes, t.fluid, ranks);
    t.ring = std::move(ring);
    t.onSolid.assign(nNodes, 0);
    t.wallPoint.assign(nNodes, 0);
    t.onWall.assign(nNodes, 0);
    for (int i = 0; i < nNodes; ++i) t.onSolid[i] = t.solid.count(i) > 0;
    t.walls = wallFaces<Dim>(mesh.patches, wallPatches(kinds), x);
    for (auto& face : t.walls)  // the edge of a solid is as its cells are
        if (face.patch >= 0 && kinds[face.patch] == PatchKind::skin) face.bent = false;
    t.convex = convexPairs<Dim>(t.walls);
    for (const auto& face : t.walls)
        if (face.patch >= 0 && isWall(kinds[face.patch]))
            for (const int node : face.nodes) t.wallPoint[node] = 1;
    t.solidFaces = boundaryFaces<Dim>(mesh.solid.nodes, t.solid);
    const auto solid = inOrder<Dim>(t.solidFaces);
    for (const auto& face : boundary) {
        const bool interface = std::binary_search(solid.begin(), solid.end(), sorted<Dim>(face.nodes));
        t.faces.push_back({face, interface ? FaceKind::interface : FaceKind::freeSurface});
    }
    setWalls<Dim>(mesh, kinds, x, wall, touching, t);
    return t;
}

template <int Dim>
Topology<Dim> makeTopology(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                           const std::vector<Supports<Dim>>& wall) {
    return makeTopology<Dim>(mesh, kinds, x, wall, Ranks());
}

template <int Dim>
Topology<Dim> withWalls(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                        const std::vector<Supports<Dim>>& wall, Topology<Dim> topology) {
    setWalls<Dim>(mesh, kinds, x, wall, touching, topology);
    return topology;
}

template <int Dim>
Topology<Dim> withContacts(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                           const std::vector<Supports<Dim>>& wall, Topology<Dim> topology) {
    setWalls<Dim>(mesh, kinds, x, wall, nearContact, topology);
    return topology;
}

#define PFEM_INSTANTIATE(D)                                                                               \
    template Topology<D> makeTopology<D>(const Mesh<D>&, const std::vector<PatchKind>&, const Points<D>&, \
                                         const std::vector<Supports<D>>&, const Ranks&);                  \
    template Topology<D> makeTopology<D>(const Mesh<D>&, const std::vector<PatchKind>&, const Points<D>&, \
                                         const std::vector<Supports<D>>&);                                \
    template Topology<D> withWalls<D>(const Mesh<D>&, const std::vector<PatchKind>&, const Points<D>&,    \
                                      const std::vector<Supports<D>>&, Topology<D>);                      \
    template Topology<D> withContacts<D>(const Mesh<D>&, const std::vector<PatchKind>&, const Points<D>&, \
                                         const std::vector<Supports<D>>&, Topology<D>);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
