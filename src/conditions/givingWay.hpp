#pragma once
// Walls that give way to waves (absorption.hpp) in a step.

#include "conditions/boundaryConditions.hpp"
#include "state/state.hpp"

namespace pfem {

/// Of these faces of a wall, the unit vector into the water across `up`; zero: more than half of them is level or
/// turned away, it is no piston.
template <int Dim>
Vec<Dim> levelNormal(const std::vector<Face<Dim>>& faces, const Points<Dim>& x, const Vec<Dim>& up);

/// The wall's surface is that of its wet part, carried on with the nodes' velocities for the time `ahead`, over a level
/// bed
///     eta = 2 int z dA/int dA - depth,      z over the lowest node.
/// Its way and velocity so far are those of its nodes less what is prescribed. `motion` of these patches gets what they
/// answer; a dry wall comes back.
template <int Dim>
void giveWay(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Nodes<Dim>& nodes,
             double t0, double t1, std::vector<RigidStep<Dim>>& motion);

}  // namespace pfem
