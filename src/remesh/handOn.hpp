#pragma once
// What a node of the surface cannot bring, those around it do.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// What is beyond a node's capacity, |amount| <= capacity, its neighbours take over in proportion to their capacities,
/// and so on for some rows of cells. Nothing is lost. Both for all nodes, capacities >= 0; images have what their
/// masters have.
template <int Dim>
void handOn(const Topology<Dim>& topology, const State<Dim>& state, std::vector<double> capacity,
            std::vector<double>& amounts);

}  // namespace pfem
