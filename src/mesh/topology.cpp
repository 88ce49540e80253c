#include "mesh/topology.hpp"

#include <algorithm>
#include <set>

namespace pfem {

namespace {

template <int Dim>
Face<Dim> sorted(Face<Dim> face) {
    std::sort(face.begin(), face.end());
    return face;
}

template <int Dim>
std::set<Face<Dim>> solidFaces(const Mesh<Dim>& mesh, const NodeToCells& around) {
    std::set<Face<Dim>> faces;
    for (const auto& face : boundaryFaces<Dim>(mesh.solid.nodes, around)) faces.insert(sorted<Dim>(face.nodes));
    return faces;
}

template <int Dim>
std::set<Face<Dim>> symmetryFaces(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds) {
    std::set<Face<Dim>> faces;
    for (std::size_t n = 0; n < mesh.patches.size(); ++n)
        if (kinds[n] == PatchKind::symmetry)
            for (const auto& face : mesh.patches[n].faces) faces.insert(sorted<Dim>(face));
    return faces;
}

/// What depends on the walls that nodes slide along; interfaces are known.
template <int Dim>
void setWalls(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const std::vector<int>& wall,
              Topology<Dim>& t) {
    for (int i = 0; i < t.nNodes(); ++i) t.onWall[i] = wall[i] >= 0;
    const auto symmetry = symmetryFaces<Dim>(mesh, kinds);
    t.freeSurface.assign(t.nNodes(), 0);
    for (auto& face : t.faces) {
        if (face.kind == FaceKind::interface) continue;
        const bool onSymmetry = !symmetry.empty() && symmetry.count(sorted<Dim>(face.nodes)) > 0;
        face.kind = onSymmetry || commonWall(t, wall, face.nodes) >= 0 ? FaceKind::wall : FaceKind::freeSurface;
        if (face.kind == FaceKind::freeSurface)
            for (int node : face.nodes) t.freeSurface[node] = 1;
    }
}

}  // namespace

template <int Dim>
Topology<Dim> makeTopology(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const std::vector<int>& wall) {
    const int nNodes = static_cast<int>(wall.size());
    Topology<Dim> t;
    t.fluid = nodeToCells<Dim>(mesh.fluid.nodes, nNodes);
    t.solid = nodeToCells<Dim>(mesh.solid.nodes, nNodes);
    auto [ring, boundary] = surroundings<Dim>(mesh.fluid.nodes, t.fluid);
    t.ring = std::move(ring);
    t.onSolid.assign(nNodes, 0);
    t.corner.assign(nNodes, 0);
    t.onWall.assign(nNodes, 0);
    for (int i = 0; i < nNodes; ++i) t.onSolid[i] = t.solid.count(i) > 0;
    for (std::size_t n = 0; n < mesh.patches.size(); ++n)
        for (const auto& face : mesh.patches[n].faces) {
            t.walls.push_back({face, isWall(kinds[n]) ? static_cast<int>(n) : -1});
            if (isWall(kinds[n]))
                for (int node : face) t.corner[node] = 1;
        }
    const auto solid = solidFaces<Dim>(mesh, t.solid);
    for (const auto& face : boundary) {
        const bool interface = !solid.empty() && solid.count(sorted<Dim>(face.nodes)) > 0;
        t.faces.push_back({face, interface ? FaceKind::interface : FaceKind::freeSurface});
    }
    setWalls<Dim>(mesh, kinds, wall, t);
    return t;
}

template <int Dim>
Topology<Dim> withWalls(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const std::vector<int>& wall,
                        Topology<Dim> topology) {
    setWalls<Dim>(mesh, kinds, wall, topology);
    return topology;
}

#define PFEM_INSTANTIATE(D)                                                                                       \
    template Topology<D> makeTopology<D>(const Mesh<D>&, const std::vector<PatchKind>&, const std::vector<int>&); \
    template Topology<D> withWalls<D>(const Mesh<D>&, const std::vector<PatchKind>&, const std::vector<int>&,     \
                                      Topology<D>);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
