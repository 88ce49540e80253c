#pragma once
// Friction of water that slides along a slip wall: its boundary layer is far thinner than a triangle.
//
//     tau_w = rho c_f |u| u / 2,   u the velocity along the wall relative to it
//
// c_f of a smooth wall is 0.079 Re^(-1/4) (Blasius; Re with four times the depth of the flow), 0.003 ... 0.006 in the
// laboratory.

#include "conditions/problem.hpp"
#include "integration/smoothingDomains.hpp"

namespace pfem {

/// u of a fluid node at x with velocity v, on solids relative to them; n: unit normal of the wall [m/s].
template <int Dim>
Vec<Dim> slidingVelocity(const Problem<Dim>& problem, int patch, const Vec<Dim>& n, const Vec<Dim>& x,
                         const Vec<Dim>& v);

/// Traction of the wall on the fluid [Pa].
template <int Dim>
Vec<Dim> wallFriction(const Problem<Dim>& problem, int patch, double rho, const Vec<Dim>& u);

/// Add the friction on all wet faces of walls to the external force, |face|/d of each node's traction; solids get its
/// reaction.
template <int Dim>
void addWallFriction(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                     const Nodes<Dim>& nodes, Points<Dim>& force);

/// Force per volume of the two walls in front of and behind a plane flow, at the distance b: - rho c_f |v| v / b
/// [N/m3].
template <int Dim>
Vec<Dim> sideFriction(const Problem<Dim>& problem, double rho, const Vec<Dim>& v);

/// Add it for the domains of the fluid.
template <int Dim>
void addSideFriction(const Problem<Dim>& problem, const Cells<Dim>& fluid, const SmoothingDomains<Dim>& domains,
                     const Points<Dim>& v, Points<Dim>& force);

/// Add the force of damping zones, - rho r(x) (v - v_zone) per volume, on the fluid's domains.
template <int Dim>
void addDamping(const Problem<Dim>& problem, const Cells<Dim>& fluid, const SmoothingDomains<Dim>& domains,
                const Nodes<Dim>& nodes, Points<Dim>& force);

}  // namespace pfem
