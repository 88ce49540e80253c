#pragma once
// Fluid between surfaces that close on it.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Nodes of the fluid for which there is no room any more: before a face of a solid by less than `reach` h, and before
/// (or behind) a wall or a face of another solid that looks the other way.
template <int Dim>
std::vector<int> pinchedNodes(const Topology<Dim>& topology, double reach, const State<Dim>& state);

}  // namespace pfem
