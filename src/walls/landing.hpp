#pragma once
// Fluid nodes come to rigid walls and slide over them.

#include "mesh/topology.hpp"
#include "state/state.hpp"
#include "walls/controls.hpp"

namespace pfem {

/// A fluid node whose path from xOld crossed a wall face, or that approaches one within landingDistance h, is put on
/// it, and on further ones that it has then crossed or come near to: from now on it slides. A drop lands where its way
/// first crosses a wall, however long it is. A node that slides is put back on its walls, over bends of less than
/// featureAngle too. Beyond the end of a wall it
///  - stays at the edge where another wall rises, held by both; in a corner (of Dim walls) if there is no node yet,
///  - goes round a convex edge under water, and leaves the wall there at the free surface,
///  - is free where the wall ends.
/// At a convex edge only calm water is held (state/calm.hpp).
template <int Dim>
void landOnWalls(const WallDistances& controls, const Topology<Dim>& topology, const Points<Dim>& xOld, double gravity,
                 State<Dim>& state);

}  // namespace pfem
