#pragma once
// Fluid nodes come to rigid walls, slide along them and leave them.

#include "material/material.hpp"
#include "mesh/topology.hpp"
#include "remesh/controls.hpp"
#include "state/state.hpp"

namespace pfem {

/// A fluid node whose path from xOld crossed a wall face, or that approaches one within landingDistance h, is put on
/// it: from now on it slides. A drop lands where its way first crosses a wall, however long it is. A sliding node that
/// has passed the end of its face stays at the end, or is free again where the wall turns away.
template <int Dim>
void landOnWalls(const RemeshingControls& controls, const Topology<Dim>& topology, const Points<Dim>& xOld,
                 State<Dim>& state);

/// A sliding node at the contact line with a suction above wallTension (rho (g h + v^2/2) + mu v/h), v relative
/// to the wall, or an isolated one that gravity pulls off, is free again. A suction that moves nothing within the step
/// of length dt is none.
template <int Dim>
void releaseFromWalls(const RemeshingControls& controls, const Topology<Dim>& topology, const Vec<Dim>& gravity,
                      const ViscousFluid& fluid, double dt, Nodes<Dim>& nodes);

/// Does the wall go on at an end of face `w` (its second node: `atEnd`) with the fluid's angle below 180 degrees?
bool isConcaveEnd(const Topology<2>& topology, const Points<2>& x, int w, bool atEnd);

}  // namespace pfem
