#pragma once
// Drops that have left everything for good.

#include <vector>

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Drops in free flight that will never meet anything again: outside the box of all nodes that are no drops,
/// on a side n (of 2 Dim) where nobody can catch up with them,
///   n . v >= n . v_J for all these nodes J,      n . v >= 0,      n . gravity >= 0,
/// so that n . x - max n . x_J only grows. They must be 2 h away, and by the size of the box where `moving`
/// walls may still go anywhere. Where there are neither walls nor solids nothing goes.
template <int Dim>
std::vector<int> goneForGood(const Topology<Dim>& topology, const Vec<Dim>& gravity, bool moving,
                             const State<Dim>& state);

}  // namespace pfem
