#pragma once
// The momentum of fluid that is meshed anew.

#include "remesh/connectivity.hpp"
#include "remesh/movedMesh.hpp"

namespace pfem {

/// Where cells have gone and others have come in their place (nodes went or came, edges turned), velocities that are
/// linear in them hold another momentum. What velocities lack so that each region of such cells that hang together by
/// faces keeps its mean velocity [m/s]:
///     dv_I = d m_I/(M_I sum_K m_K),   d = sum_new |e| (v_old - v_e),   v_old = sum_old |e| v_e / sum_old |e|,
/// M_I the volume of the node's patch, m_I what of it lies in the region's new cells. Cells that are contacts are of no
/// region, those that were dropped (`changes`) still of theirs: they bring and take their own momentum. `vOld`: of the
/// nodes of `moved`, `newIndex`: of the same, -1: gone; `nOwnCells`: cells of `moved` that count. The state has its new
/// cells, without copies.
template <int Dim>
Points<Dim> missingVelocity(const MovedMesh<Dim>& moved, const Points<Dim>& vOld, int nOwnCells,
                            const std::vector<int>& newIndex, const std::vector<CellChange<Dim>>& changes,
                            const State<Dim>& state);

}  // namespace pfem
