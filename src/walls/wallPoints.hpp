#pragma once
// Walls are geometry: their points are no nodes of the fluid.

#include "state/state.hpp"

namespace pfem {

/// Give walls points of their own: where a wall shares a node with a body, its faces get a copy. Then every node of the
/// fluid that lies on walls (to 1e-6 h), and has no support yet, gets them as supports. States of versions in which
/// corners of walls were nodes of the fluid become such as this one makes. `isWall`: per patch.
template <int Dim>
void separateFromWalls(const std::vector<bool>& isWall, State<Dim>& state);

}  // namespace pfem
