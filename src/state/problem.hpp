#pragma once
// What does not change during a run: physics and boundary conditions.

#include "material/material.hpp"
#include "momentum/boundaryConditions.hpp"
#include "state/state.hpp"

namespace pfem {

template <int Dim>
struct Problem {
    std::vector<Material> materials;  // in the order of Mesh::materials
    Vec<Dim> gravity = Vec<Dim>::Zero();
    BoundaryConditions<Dim> conditions;

    const Newtonian& fluid(int material) const { return materials[material].fluid; }
    const Hypoelastic& solid(int material) const { return materials[material].solid; }
};

}  // namespace pfem
