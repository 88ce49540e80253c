#pragma once
// What follows from the mesh alone, once per triangulation: roles of nodes and kinds of faces.

#include <algorithm>
#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/mesh.hpp"
#include "mesh/ride.hpp"
#include "mesh/wallFaces.hpp"

namespace pfem {

/// What the mesh must know of a patch; its type (conditions/patchType.hpp) says more.
enum class PatchKind {
    wall,      // rigid: fluid nodes land on it and leave it
    symmetry,  // a plane that cuts a body
    edge,      // of a solid
    skin,      // of a solid: fluid nodes land on it and leave it as a wall
    opening    // a wall through which fluid comes or goes: nodes on it are held as on walls, but pass through it
};

/// Does it hold fluid nodes (openings do)?
inline bool isWall(PatchKind kind) { return kind == PatchKind::wall || kind == PatchKind::opening; }

/// Do nodes of the fluid slide over it?
inline bool holdsFluid(PatchKind kind) { return isWall(kind) || kind == PatchKind::skin; }

/// Which patches do.
inline std::vector<bool> wallPatches(const std::vector<PatchKind>& kinds) {
    std::vector<bool> walls;
    for (const PatchKind kind : kinds) walls.push_back(holdsFluid(kind));
    return walls;
}

/// Nodes of solids and of all patches (points of walls, planes of symmetry): the fluid's remeshing leaves them as they
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
    int wall = -1;  // of a face on a rigid wall: the wall face under it, a support of its first node
};

template <int Dim>
struct Topology {
    NodeToCells fluid;  // fluid cells around each node
    NodeToCells solid;  // solid cells around each node
    NodeToNodes ring;   // neighbours in the fluid
    std::vector<FluidFace<Dim>> faces;
    std::vector<BoundaryFace<Dim>> solidFaces;  // of solids, without a neighbour in them
    std::vector<WallFace<Dim>> walls;           // faces of all patches in their order, as counted by Nodes::wall
    std::vector<std::pair<int, int>> convex;    // regions of the walls that meet at a convex edge
    std::vector<Supports<Dim>> supports;        // Nodes::wall; of solids' nodes: the walls that they touch
    std::vector<unsigned char> onSolid;         // node of a solid body
    std::vector<unsigned char> wallPoint;       // of a wall, or a solid under a skin: geometry, no node of the fluid
    std::vector<unsigned char> onWall;          // of the fluid, held by a rigid wall
    std::vector<unsigned char> freeSurface;     // node of a free-surface face
    std::vector<PatchKind> kinds;               // of the patches
    std::vector<Ride<Dim>> rides;               // on skins, by ascending nodes

    int nNodes() const { return static_cast<int>(onSolid.size()); }
    bool wet(int node) const { return fluid.count(node) > 0; }
    bool isolated(int node) const { return !wet(node) && ofFluid(node); }
    bool interface(int node) const { return wet(node) && onSolid[node]; }
    bool ofFluid(int node) const { return !onSolid[node] && !wallPoint[node]; }  // and of nothing else

    bool isOpening(int wall) const { return isOf(wall, PatchKind::opening); }
    bool isSkin(int wall) const { return isOf(wall, PatchKind::skin); }
    bool isUnderSkin(int node) const { return onSolid[node] && wallPoint[node]; }
    /// Of the fluid, held by an inlet or an outlet (and perhaps by walls, too).
    bool onOpening(int node) const {
        const auto& own = supports[node];
        return onWall[node] && std::any_of(own.begin(), own.end(), [&](int w) { return w >= 0 && isOpening(w); });
    }

    /// Are two wall faces of one region, or of two between which water flows round a convex edge?
    bool joined(int face, int other) const {
        const int a = walls[face].region, b = walls[other].region;
        return a == b || std::binary_search(convex.begin(), convex.end(), std::pair(a, b));
    }
    /// Have all nodes of a face a support on one wall?
    bool liesOnWall(const Face<Dim>& face) const {
        const auto& own = supports[face[0]];
        return std::any_of(own.begin(), own.end(), [&](int wall) {
            return wall >= 0 &&
                   std::all_of(face.begin(), face.end(), [&](int node) { return supportOn(node, wall) >= 0; });
        });
    }
    /// The support of a node that is joined with a wall face, -1: none.
    int supportOn(int node, int face) const {
        for (const int own : supports[node])
            if (own >= 0 && joined(own, face)) return own;
        return -1;
    }
    /// The node's ride on a wall face, or else on one that is joined with it; null: none.
    const Ride<Dim>* rideOn(int node, int face) const {
        auto ride =
            std::lower_bound(rides.begin(), rides.end(), node, [](const Ride<Dim>& r, int i) { return r.node < i; });
        const Ride<Dim>* found = nullptr;
        for (; ride != rides.end() && ride->node == node; ++ride) {
            if (ride->wall == face) return &*ride;
            if (!found && joined(ride->wall, face)) found = &*ride;
        }
        return found;
    }

private:
    bool isOf(int wall, PatchKind kind) const { return walls[wall].patch >= 0 && kinds[walls[wall].patch] == kind; }
};

/// `kinds`: one per patch of the mesh; x, wall: of the nodes. A fluid face is an interface where a solid face
/// coincides, a wall where all its nodes lie on joined walls whose normals it has, or on one symmetry patch, and free
/// surface otherwise. Two free-surface nodes do not make a face.
template <int Dim>
Topology<Dim> makeTopology(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                           const std::vector<Supports<Dim>>& wall);

/// The same mesh after nodes have landed on walls or left them.
template <int Dim>
Topology<Dim> withWalls(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                        const std::vector<Supports<Dim>>& wall, Topology<Dim> topology);

}  // namespace pfem
