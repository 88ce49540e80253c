#pragma once
// What nodes under the surface lack comes up to those that can make up for it.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// From the deepest row of cells on each node hands `amounts` evenly to its neighbours in the next row; row 0 is
/// `surface`. Nothing is lost; nodes that hang together with no surface keep theirs. Images have what their masters
/// have.
template <int Dim>
void bringUp(const Topology<Dim>& topology, const State<Dim>& state, const std::vector<int>& surface,
             std::vector<double>& amounts);

/// What is beyond a node's capacity, |amount| <= capacity, its neighbours take over in proportion to their capacities,
/// and so on for some rows of cells. Nothing is lost. Both for all nodes, capacities >= 0.
template <int Dim>
void handOn(const Topology<Dim>& topology, const State<Dim>& state, std::vector<double> capacity,
            std::vector<double>& amounts);

}  // namespace pfem
