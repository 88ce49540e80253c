#pragma once
// Who is joined to whom, found by ranks that share the work.

#include "mesh/topology.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

/// Where each rank's run of nodes ends, with equal numbers of cells around them: nodes have the order of a curve that
/// fills space, so that those of a run are near to each other.
std::vector<std::size_t> nodeRuns(const Ranks& ranks, const NodeToCells& around);

/// surroundings(): each rank looks around the nodes of its run.
template <int Dim>
Surroundings<Dim> surroundings(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around, const Ranks& ranks);

/// makeTopology() of it.
template <int Dim>
Topology<Dim> makeTopology(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                           const std::vector<Supports<Dim>>& wall, const Ranks& ranks);

}  // namespace pfem
