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

}  // namespace

template <int Dim>
Topology<Dim> makeTopology(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const std::vector<int>& wall) {
    const int nNodes = static_cast<int>(wall.size());
    Topology<Dim> t;
    t.fluid = nodeToCells<Dim>(mesh.fluid.nodes, nNodes);
    t.solid = nodeToCells<Dim>(mesh.solid.nodes, nNodes);
    t.ring = nodeToNodes<Dim>(mesh.fluid.nodes, t.fluid);
    t.onSolid.assign(nNodes, 0);
    t.corner.assign(nNodes, 0);
    t.onWall.assign(nNodes, 0);
    t.freeSurface.assign(nNodes, 0);
    for (int i = 0; i < nNodes; ++i) {
        t.onSolid[i] = t.solid.count(i) > 0;
        t.onWall[i] = wall[i] >= 0;
    }

    std::set<Face<Dim>> symmetryFaces;
    for (std::size_t n = 0; n < mesh.patches.size(); ++n)
        for (const auto& face : mesh.patches[n].faces) {
            t.walls.push_back({face, isWall(kinds[n]) ? static_cast<int>(n) : -1});
            if (isWall(kinds[n]))
                for (int node : face) t.corner[node] = 1;
            if (kinds[n] == PatchKind::symmetry) symmetryFaces.insert(sorted<Dim>(face));
        }

    const auto solid = solidFaces<Dim>(mesh, t.solid);
    for (const auto& face : boundaryFaces<Dim>(mesh.fluid.nodes, t.fluid)) {
        const Face<Dim> key = sorted<Dim>(face.nodes);
        FaceKind kind = FaceKind::freeSurface;
        if (solid.count(key))
            kind = FaceKind::interface;
        else if (symmetryFaces.count(key) || commonWall(t, wall, face.nodes) >= 0)
            kind = FaceKind::wall;
        t.faces.push_back({face, kind});
        if (kind == FaceKind::freeSurface)
            for (int node : face.nodes) t.freeSurface[node] = 1;
    }
    return t;
}

template Topology<2> makeTopology<2>(const Mesh<2>&, const std::vector<PatchKind>&, const std::vector<int>&);
template Topology<3> makeTopology<3>(const Mesh<3>&, const std::vector<PatchKind>&, const std::vector<int>&);

}  // namespace pfem
