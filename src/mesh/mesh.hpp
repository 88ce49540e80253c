#pragma once
// The mesh: who is joined to whom. Positions live in Nodes, so that one mesh serves every iterate.

#include <string>
#include <vector>

#include "base/history.hpp"
#include "base/types.hpp"

namespace pfem {

/// Simplices of one kind (fluid or solid) with their material; the material belongs to the ELEMENT.
template <int Dim>
struct Cells {
    std::vector<Simplex<Dim>> nodes;
    std::vector<int> material;            // per cell: index into Mesh::materials
    std::vector<Stress<Dim>> sigma = {};  // Cauchy stress [Pa] of solid cells with elemental integration, else empty
    History history = {};                 // of the solids' laws, with elemental integration

    int size() const { return static_cast<int>(nodes.size()); }
};

/// A named group of faces: a rigid wall, a clamped or a loaded edge of a solid.
/// What the name means is said by constant/boundaryConditions.
template <int Dim>
struct Patch {
    std::string name;
    std::vector<Face<Dim>> faces;  // walls: fluid on the left of a -> b (2D)
};

template <int Dim>
struct Mesh {
    Cells<Dim> fluid;  // rebuilt as the fluid moves
    Cells<Dim> solid;  // kept for the whole run
    std::vector<Patch<Dim>> patches;
    std::vector<std::string> materials;  // names as in constant/materials
};

}  // namespace pfem
