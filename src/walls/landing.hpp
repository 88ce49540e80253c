#pragma once
// Fluid nodes come to rigid walls and slide over them.

#include "mesh/topology.hpp"
#include "state/state.hpp"
#include "walls/controls.hpp"

namespace pfem {

/// A fluid node whose path from xOld crossed a wall face, or that approaches one within landingDistance h, is put on
/// it: from now on it slides. A drop lands where its way first crosses a wall, however long it is. A node that slides
/// is put back on its wall, over bends of less than featureAngle too. Beyond the end of its wall it
///  - stays in the corner where another wall rises, held by both, if there is no node yet,
///  - goes round a convex corner under water, and leaves the wall there at the free surface,
///  - is free where the wall ends.
/// In a convex corner only calm water is held (state/calm.hpp).
template <int Dim>
void landOnWalls(const WallDistances& controls, const Topology<Dim>& topology, const Points<Dim>& xOld, double gravity,
                 State<Dim>& state);

}  // namespace pfem
