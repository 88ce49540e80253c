#pragma once
// Cells that a wall cuts.

#include "remesh/connectivity.hpp"

namespace pfem {

/// Of the cells `asked`, those with a wall between two nodes, one of which has come round the wall's end and is behind
/// it: what is before the wall is not joined with it.
template <int Dim>
std::vector<int> cutByWalls(const CandidateNodes<Dim>& nodes, const MovedMesh<Dim>& moved,
                            const Triangulation<Dim>& triangulation, const std::vector<int>& asked);

}  // namespace pfem
