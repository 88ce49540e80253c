#pragma once
// A local account of volume. Remeshing the surface, walls and the solver's tolerance take volume from the
// fluid or give it; each node remembers what its surroundings lack (Nodes::lostVolume), and the continuity
// equation returns it there within `volumeReturnTime`. At all times, to round-off,
//
//     sum of cells + sum of dropVolume + sum of lostVolume = initial volume + ledger's `compression`.

#include "mesh/adjacency.hpp"
#include "remesh/connectivity.hpp"
#include "remesh/movedMesh.hpp"
#include "remesh/nodeControl.hpp"

namespace pfem {

/// The nodes moved from xOld: each patch is charged with its change, lost_I -= Omega_I(x) - Omega_I(xOld).
/// Then every cell levels what its nodes lack, so that the return does not press on single nodes:
///     lost_I <- sum_e D_e/(d+1),   D_e = sum_K lost_K |e|/((d+1) Omega_K).
template <int Dim>
void chargeMotion(const NodeToCells& around, const std::vector<Simplex<Dim>>& cells, const Points<Dim>& xOld,
                  Nodes<Dim>& nodes);

/// Book a remeshing into its sheet and into what nodes lack. `changes`: a third of each triangle to each of its nodes;
/// what is left of the change of all cells is `reshaped`: of a removed surface node, the triangle that it cuts off,
/// half to each of its neighbours; the rest to all surface nodes. Removed nodes and dry places on walls and solids hand
/// what they lack to their ring. Nodes without triangles carry it as a drop. The state has its new cells; `newIndex`:
/// of the old nodes.
template <int Dim>
void bookRemeshing(const MovedMesh<Dim>& moved, const NodePlan<Dim>& plan, const std::vector<int>& newIndex,
                   const std::vector<CellChange<Dim>>& changes, VolumeLedger& sheet, State<Dim>& state);

}  // namespace pfem
