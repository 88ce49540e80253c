#pragma once
// Which cells have a face in common.

#include "base/types.hpp"

namespace pfem {

/// Beyond the face opposite to node k of each cell; -1: none. No face has more than two cells.
std::vector<std::array<int, 4>> cellNeighbours(const std::vector<Simplex<3>>& cells, int nNodes);

}  // namespace pfem
