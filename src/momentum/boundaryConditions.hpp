#pragma once
// What the patches mean for the momentum equation: constant/boundaryConditions.

#include <vector>

#include "dictionary/dictionary.hpp"
#include "mesh/topology.hpp"

namespace pfem {

/// One entry per patch of the mesh.
template <int Dim>
struct BoundaryConditions {
    std::vector<PatchKind> kind;
    std::vector<Vec<Dim>> traction;  // [Pa]; traction patches only
};

/// Read the condition of every patch. Throws UserError for a patch without entry, an entry without patch, and
/// unknown types.
template <int Dim>
BoundaryConditions<Dim> readBoundaryConditions(const Dictionary& dict, const std::vector<Patch<Dim>>& patches);

/// How a node may move.
enum class Hold : unsigned char {
    free,
    fixed,  // clamped
    slide,  // only perpendicular to its normal
    wall    // rigid wall: position prescribed; its velocity is the fluid's velocity at the wall
};

template <int Dim>
struct NodeConstraints {
    std::vector<Hold> hold;
    std::vector<Vec<Dim>> normal;     // of sliding nodes and of slip-wall nodes; zero at corners
    std::vector<unsigned char> slip;  // wall nodes on a slip wall away from corners

    /// The part of u that node i may perform.
    Vec<Dim> project(int i, const Vec<Dim>& u) const {
        if (hold[i] == Hold::free) return u;
        if (hold[i] == Hold::slide) return u - normal[i] * normal[i].dot(u);
        return Vec<Dim>::Zero();
    }
};

/// Constraints of all nodes; normals from the reference positions X. A node where two directions meet at more
/// than 20 degrees is a corner: fixed on symmetry patches, at rest on walls. Solids hold before walls.
template <int Dim>
NodeConstraints<Dim> nodeConstraints(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                                     const Topology<Dim>& topology, const Points<Dim>& X);

/// Slip walls: the wall's fluid moves with the tangential mean of its neighbours off the wall. Sets v of wall
/// nodes (zero on no-slip walls, at corners and where dry).
template <int Dim>
void setWallVelocities(const NodeConstraints<Dim>& constraints, const Topology<Dim>& topology,
                       const std::vector<Simplex<Dim>>& fluid, Points<Dim>& v);

}  // namespace pfem
