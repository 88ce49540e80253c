#pragma once
// The ledger's fields after a remeshing: what nodes leave behind goes to their old neighbours.

#include "remesh/movedMesh.hpp"
#include "state/state.hpp"

namespace pfem {

/// Post the sheet of a remeshing. Where fields are counted, the amounts of the old nodes are added to those of the new
/// ones; what has no place in fluid.vtu any more, nodes that went and dry places on walls and solids, hands its amounts
/// to its old neighbours, or to all of the fluid. Their sum over the nodes of fluid.vtu is the change of the ledger, to
/// round-off. `newIndex`: of the old nodes, -1: gone.
template <int Dim>
void postRemeshing(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex, VolumeLedger sheet,
                   State<Dim>& state);

}  // namespace pfem
