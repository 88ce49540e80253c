#pragma once
// Fluid nodes leave rigid walls.

#include "material/material.hpp"
#include "mesh/topology.hpp"
#include "state/state.hpp"
#include "walls/controls.hpp"

namespace pfem {

/// A sliding node at the contact line with a suction above wallTension (rho (g h + v^2/2) + mu v/h), v relative
/// to the wall, or an isolated one that gravity pulls off, is free again. A suction that moves nothing within the step
/// of length dt is none.
template <int Dim>
void releaseFromWalls(const WallControls& controls, const Topology<Dim>& topology, const Vec<Dim>& gravity,
                      const ViscousFluid& fluid, double dt, Nodes<Dim>& nodes);

}  // namespace pfem
