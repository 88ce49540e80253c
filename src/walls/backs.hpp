#pragma once
// Water that has come over the rim of a wall keeps off the wall's back.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Unsupported fluid nodes near the back of a rigid wall go 0.7 h off it, by no more than 0.25 h in a step, and their
/// velocity towards it (relative to the wall) is removed. Nearer they would be within the circumspheres of the cells
/// before the wall, which the triangulation would give up for cells through the wall. Not beside the wall's end, round
/// which cells may go.
template <int Dim>
void keepOffBacks(const Topology<Dim>& topology, Nodes<Dim>& nodes);

}  // namespace pfem
