#pragma once
// Fluid nodes come to rigid walls and slide along them.

#include "mesh/topology.hpp"
#include "state/state.hpp"
#include "walls/controls.hpp"

namespace pfem {

/// A fluid node whose path from xOld crossed a wall face, or that approaches one within landingDistance h, is put on
/// it: from now on it slides. A drop lands where its way first crosses a wall, however long it is. A sliding node that
/// has passed the end of its face stays at the end, or is free again where the wall turns away.
template <int Dim>
void landOnWalls(const WallControls& controls, const Topology<Dim>& topology, const Points<Dim>& xOld,
                 State<Dim>& state);

}  // namespace pfem
