#pragma once
// Where the fluid touches walls and solids: what pressures and forces on them are taken from.

#include <vector>

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// A face of the fluid on a rigid wall or on a solid; the fluid is on its left, faceArea points out of the
/// fluid.
template <int Dim>
struct WetFace {
    Face<Dim> nodes{};
    int cell = -1;   // of the fluid
    int patch = -1;  // of the wall, or of the solid over which fluid slides; -1 where it sticks to solids
    int solid = -1;  // the solid's material (index into Mesh::materials), -1 on walls
    std::array<Vec<Dim>, Dim> under{};  // velocity of the solid under the nodes that slide over it, else zero
};

/// In the order of the fluid's faces. Symmetry patches are left out.
template <int Dim>
std::vector<WetFace<Dim>> wetFaces(const State<Dim>& state, const Topology<Dim>& topology);

}  // namespace pfem
