#pragma once
// Rigid walls as straight faces between corners, with fluid nodes that slide along them.

#include <string>
#include <vector>

#include "state/state.hpp"

namespace pfem {

/// Give walls that move nodes of their own: where one meets another wall, the other one gets a copy of the node.
void separateWalls(const std::vector<std::string>& walls, const std::vector<std::string>& moving, State<2>& state);

/// Join the faces of each wall into straight ones. The nodes between their ends are no part of the wall any more:
/// dry ones vanish, those of the fluid slide (Nodes::wall). Corners, ends and nodes of solids stay.
/// `walls`: names of the patches that are walls.
void straightenWalls(const std::vector<std::string>& walls, State<2>& state);

}  // namespace pfem
