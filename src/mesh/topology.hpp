#pragma once
// What follows from the mesh alone, once per triangulation: roles of nodes and kinds of faces.

#include <algorithm>
#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/mesh.hpp"

namespace pfem {

/// What the mesh must know of a patch; its type (conditions/patchType.hpp) says more.
enum class PatchKind {
    wall,      // rigid: fluid nodes land on it and leave it
    symmetry,  // a plane that cuts a body
    edge       // of a solid
};

inline bool isWall(PatchKind kind) { return kind == PatchKind::wall; }

/// Which patches are walls.
inline std::vector<bool> wallPatches(const std::vector<PatchKind>& kinds) {
    std::vector<bool> walls;
    for (const PatchKind kind : kinds) walls.push_back(isWall(kind));
    return walls;
}

/// Nodes of solids and of all patches (corners of walls, planes of symmetry): the fluid's remeshing leaves them as they
/// are.
template <int Dim>
std::vector<unsigned char> keptNodes(const Mesh<Dim>& mesh, int nNodes) {
    std::vector<unsigned char> kept(nNodes, 0);
    for (const auto& cell : mesh.solid.nodes)
        for (int node : cell) kept[node] = 1;
    for (const auto& patch : mesh.patches)
        for (const auto& face : patch.faces)
            for (int node : face) kept[node] = 1;
    return kept;
}

/// Nodes of no cell and no patch: drops in free flight, or on their way along a wall.
template <int Dim>
std::vector<unsigned char> looseNodes(const Mesh<Dim>& mesh, int nNodes) {
    auto loose = keptNodes<Dim>(mesh, nNodes);
    for (const auto& cell : mesh.fluid.nodes)
        for (int node : cell) loose[node] = 1;
    for (auto& one : loose) one = !one;
    return loose;
}

enum class FaceKind { freeSurface, interface, wall };

/// A face of the fluid without a fluid neighbour.
template <int Dim>
struct FluidFace : BoundaryFace<Dim> {
    FaceKind kind;
};

/// A face of a rigid wall: a straight piece between two corners (2D). Fluid nodes slide along it.
template <int Dim>
struct WallFace {
    Face<Dim> nodes;  // the corners, fluid on the left
    int patch = -1;   // -1: the face is not of a wall
};

template <int Dim>
struct Topology {
    NodeToCells fluid;  // fluid cells around each node
    NodeToCells solid;  // solid cells around each node
    NodeToNodes ring;   // neighbours in the fluid
    std::vector<FluidFace<Dim>> faces;
    std::vector<WallFace<Dim>> walls;        // faces of all patches in their order, as counted by Nodes::wall
    std::vector<unsigned char> onSolid;      // node of a solid body
    std::vector<unsigned char> corner;       // corner of a rigid wall
    std::vector<unsigned char> onWall;       // slides along a rigid wall
    std::vector<unsigned char> freeSurface;  // node of a free-surface face

    int nNodes() const { return static_cast<int>(onSolid.size()); }
    bool wet(int node) const { return fluid.count(node) > 0; }
    bool isolated(int node) const { return !wet(node) && !onSolid[node] && !corner[node]; }
    bool interface(int node) const { return wet(node) && onSolid[node]; }
    bool onSolidOrCorner(int node) const { return onSolid[node] || corner[node]; }  // a place that fluid comes to
};

/// The wall face that all `nodes` lie on, as corners or sliding; -1 when there is none.
template <int Dim, std::size_t N>
int commonWall(const Topology<Dim>& topology, const std::vector<int>& wall, const std::array<int, N>& nodes) {
    const auto allLie = [&](int w) {
        const auto& corners = topology.walls[w].nodes;
        return topology.walls[w].patch >= 0 && std::all_of(nodes.begin(), nodes.end(), [&](int node) {
                   return wall[node] == w || std::find(corners.begin(), corners.end(), node) != corners.end();
               });
    };
    for (int node : nodes) {  // a corner that stands on another wall lies on its own faces, too
        if (wall[node] < 0) continue;
        if (allLie(wall[node])) return wall[node];
        if (!topology.corner[node]) return -1;
    }
    for (int w = 0; topology.corner[nodes[0]] && w < static_cast<int>(topology.walls.size()); ++w)
        if (allLie(w)) return w;  // corners only: rare
    return -1;
}

/// `kinds`: one per patch of the mesh; `wall`: Nodes::wall.
/// A fluid face is an interface where a solid face coincides, a wall where all its nodes lie on one wall face or
/// one symmetry patch, and free surface otherwise. Two free-surface nodes do not make a face.
template <int Dim>
Topology<Dim> makeTopology(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const std::vector<int>& wall);

/// The same mesh after nodes have landed on walls or left them.
template <int Dim>
Topology<Dim> withWalls(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const std::vector<int>& wall,
                        Topology<Dim> topology);

}  // namespace pfem
