#pragma once
// Walls that give way to waves (absorption.hpp) in a step.

#include "conditions/boundaryConditions.hpp"
#include "state/state.hpp"

namespace pfem {

/// The wall's surface is that of its wet part, carried on with the nodes' velocities for the time `ahead`,
///     eta = (wet area across the wall)/(its width) - depth,
/// the width (2D: 1) being that of the wet part. Its way and velocity so far are those of its nodes less what is
/// prescribed. `motion` of these patches gets what they answer.
template <int Dim>
void giveWay(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Nodes<Dim>& nodes,
             double t0, double t1, std::vector<RigidStep<Dim>>& motion);

}  // namespace pfem
