#pragma once
// Walls that stand on other walls: the foot of a piston or of a gate on the floor.

#include "state/state.hpp"

namespace pfem {

/// A corner of one wall that lies on a face of another wall, none of whose ends it is, stands on it: Nodes::wall is
/// that face, and the fluid's nodes on the face cannot pass. Corners that have left their face get -1.
/// `isWall`: per patch of the mesh.
void standOnWalls(const Mesh<2>& mesh, const std::vector<bool>& isWall, Nodes<2>& nodes);

}  // namespace pfem
