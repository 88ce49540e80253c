#pragma once
// The ledger as fields: the fluid volume that appeared around each node, by cause (State::appeared). Counted only when
// somebody has asked. The sum over the nodes of fluid.vtu is the change of the ledger, to round-off.

#include "remesh/connectivity.hpp"
#include "remesh/movedMesh.hpp"
#include "state/state.hpp"

namespace pfem {

/// Count from here on, all causes from zero; `gone` only when something has gone.
template <int Dim>
void countAppeared(State<Dim>& state);

/// After a remeshing: 1/(d+1) of each contact and peeled cell to its nodes, `reshaped` as it is, drops to themselves,
/// those that are let go to all of the fluid. What has no place in fluid.vtu any more, nodes that went and dry places
/// on walls and solids, hands its amounts to its old neighbours. `newIndex`: of the old nodes; `reshaped`: per new
/// node.
template <int Dim>
void bookRemeshing(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex, const Connectivity& selected,
                   const std::vector<double>& reshaped, State<Dim>& state);

}  // namespace pfem
