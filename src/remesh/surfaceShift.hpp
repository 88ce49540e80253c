#pragma once
// The free surface gives way: what its nodes have lost or gained comes back by their own displacement, at once.

#include "mesh/topology.hpp"
#include "remesh/controls.hpp"
#include "state/state.hpp"

namespace pfem {

/// Each node of the free surface moves along a_I = sum_e |e| grad N_I, outwards, until its cells have gained
/// what it lacks,
///     dx_I = L_I a_I/|a_I|^2,   |dx_I| <= surfaceShift h,   L = `share` of lost, half of it shared with the neighbours
///     along the surface,
/// on a wall along the wall. In space what is beyond a node's limit, or held back with it, its neighbours bring
/// (handOn). No cell loses more than half of its volume, none becomes small. The cells of `topology`
/// are those of the state; `returned`: what this step has already given to each node. chargeMotion charges the
/// displacement with the rest of the step's motion.
template <int Dim>
void shiftSurface(const RemeshingControls& controls, const Topology<Dim>& topology, const std::vector<double>& returned,
                  double share, State<Dim>& state);

}  // namespace pfem
