#pragma once
// Which nodes and cells of a step each rank works off.

#include "mesh/adjacency.hpp"
#include "parallel/share.hpp"
#include "solver/controls.hpp"

namespace pfem {

/// What `rank` works off when its own nodes are the run that ends at ends[rank]. `around`: of the fluid's `cells`.
template <int Dim>
Share partOf(const Ranks& ranks, int rank, std::vector<std::size_t> ends, const std::vector<Simplex<Dim>>& cells,
             const NodeToCells& around);

/// Of the ranks that `controls` names: runs of nodes with equal numbers of cells around them. Everything in each rank
/// where elements carry the stress, or the stabilisation asks for a mean over all.
template <int Dim>
Share shareOf(const Controls& controls, const std::vector<Simplex<Dim>>& cells, const NodeToCells& around);

}  // namespace pfem
