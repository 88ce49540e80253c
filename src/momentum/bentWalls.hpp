#pragma once
// Where a wall is bent, the fluid's faces are chords of it. What flows through a chord on one side of a node comes back
// through the other; pressure on chords would drive the nodes along the wall. Neither is there on the wall itself:
//
//     div:   - int_f N_I (v - v_wall) . n dS      force:   - int_f p N_J n dS
//
// over the chords f are added to the equations, each the other's adjoint. So hydrostatic pressure balances gravity on a
// bent wall to round-off, wherever its nodes are. On a solid, whose edge bends as it likes, every face is a chord, and
// the solid gets the pressure: v_wall is its velocity under the node.

#include "conditions/constraints.hpp"

namespace pfem {

/// Forces of the pressure that the nodes at their places have on the chords, and on solids there (2D: N/m).
template <int Dim>
void addChordPressure(const Topology<Dim>& topology, const Nodes<Dim>& nodes, Points<Dim>& force);

/// Take what flows through the chords with the nodes' free velocities, on solids with those relative to the solids,
/// from the continuity equation's residual
/// [m2/s (2D), m3/s].
template <int Dim>
void subtractChordFlux(const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, const Nodes<Dim>& nodes,
                       std::vector<double>& residual);

}  // namespace pfem
