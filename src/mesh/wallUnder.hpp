#pragma once
// On which wall a face of the fluid lies.

#include <algorithm>
#include <cmath>

#include "mesh/simplex.hpp"
#include "mesh/topology.hpp"

namespace pfem {

/// What the walls under the nodes of a face say of it.
template <int Dim>
struct UnderFace {
    Vec<Dim> inward = Vec<Dim>::Zero();  // sum of the walls' normals into the fluid
    bool oneRegion = true;               // no convex edge between the nodes
    bool facing = true;                  // at each node one is within 60 degrees of the face's own

    /// Add a node with these supports. False when none of them is joined with `wall`.
    bool add(const Topology<Dim>& topology, const Points<Dim>& x, int wall, const Supports<Dim>& supports,
             const Vec<Dim>& outward) {
        bool held = false, ofRegion = false, faces = false;
        for (const int own : supports) {
            if (own < 0 || !topology.joined(own, wall)) continue;
            const Vec<Dim> normal = inwardNormal<Dim>(x, topology.walls[own].nodes);
            inward += normal;
            held = true;
            ofRegion = ofRegion || topology.walls[own].region == topology.walls[wall].region;
            faces = faces || outward.dot(normal) < -0.5;
        }
        oneRegion = oneRegion && ofRegion;
        facing = facing && faces;
        return held;
    }
};

/// The wall face under a face of the fluid with the unit normal `outward`, -1: none: a support of the first node with
/// which all have a joined one, so that the face has the normal of the walls under its nodes. On one region each node
/// must say so: the surface of a round tank goes from wall to wall as well, and the sum of those normals may be
/// anything. supports(node): of the face's nodes; x: places of the walls' nodes.
template <int Dim, class SupportsOf>
int wallUnder(const Topology<Dim>& topology, const Points<Dim>& x, const Face<Dim>& face, const Vec<Dim>& outward,
              SupportsOf&& supports) {
    for (const int wall : supports(face[0])) {
        if (wall < 0) continue;
        UnderFace<Dim> under;
        const bool all = std::all_of(face.begin(), face.end(),
                                     [&](int node) { return under.add(topology, x, wall, supports(node), outward); });
        if (all && outward.dot(under.inward) < -0.5 * under.inward.norm() && (under.facing || !under.oneRegion))
            return wall;
    }
    return -1;
}

/// The walls on which all nodes of a face lie.
template <int Dim>
Supports<Dim> commonWalls(const Topology<Dim>& topology, const Face<Dim>& face) {
    Supports<Dim> common = unsupported<Dim>();
    for (const int wall : topology.supports[face[0]])
        if (wall >= 0 &&
            std::all_of(face.begin(), face.end(), [&](int node) { return topology.supportOn(node, wall) >= 0; }))
            addSupport(common, wall);
    return common;
}

/// Has the face no area, its nodes being on the edge of Dim - 1 walls? Then it lies on each of them and has no normal.
/// So it is where a node of one wall has just come to the other, between two that were there.
template <int Dim>
bool isAlongEdge(const Points<Dim>& x, const Face<Dim>& face, const Supports<Dim>& common) {
    if (nSupports(common) < Dim - 1) return false;
    double size = 0;
    for (const int i : face) size = std::max(size, (x[i] - x[face[0]]).norm());
    return faceArea<Dim>(x, face).norm() < 1e-9 * std::pow(size, Dim - 1);
}

}  // namespace pfem
