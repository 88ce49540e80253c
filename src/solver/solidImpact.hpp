#pragma once
// Solids that strike each other or a wall at the start of a step.

#include "momentum/step.hpp"
#include "solver/controls.hpp"

namespace pfem {

/// Solids that touch and approach each other stop: an inelastic impact without friction that lasts no time, after which
/// no pair closes before the middle of the step (ContactForces::strikes). `step`: that begins; constraints, nodes: its
/// own, whose twists and velocities change. False, and nothing happens, without a contact that strikes.
template <int Dim>
bool stopStruckSolids(const Step<Dim>& step, const Controls& controls, NodeConstraints<Dim>& constraints,
                      Nodes<Dim>& nodes);

}  // namespace pfem
