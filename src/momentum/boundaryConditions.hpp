#pragma once
// What the patches mean for the momentum equation: constant/boundaryConditions.

#include <vector>

#include "dictionary/dictionary.hpp"
#include "mesh/topology.hpp"
#include "state/state.hpp"

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
    fixed,  // clamped, or stuck to a rigid wall
    slide   // only perpendicular to its normal
};

template <int Dim>
struct NodeConstraints {
    std::vector<Hold> hold;
    std::vector<Vec<Dim>> normal;  // of sliding nodes

    /// The part of u that node i may perform.
    Vec<Dim> project(int i, const Vec<Dim>& u) const {
        if (hold[i] == Hold::free) return u;
        if (hold[i] == Hold::slide) return u - normal[i] * normal[i].dot(u);
        return Vec<Dim>::Zero();
    }
};

/// Constraints of all nodes. On symmetry patches normals come from the reference positions X; a node where two of
/// them meet at more than 20 degrees is fixed. A fluid node on a slip wall slides along its wall face; on a no-slip
/// wall it sticks, except at the contact line, which could not move otherwise. Solids hold before walls.
template <int Dim>
NodeConstraints<Dim> nodeConstraints(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions,
                                     const Topology<Dim>& topology, const Nodes<Dim>& nodes);

}  // namespace pfem
