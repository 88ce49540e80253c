#pragma once
// Water comes in through inlets and goes through outlets. In the step nodes on both move with the water as all others;
// then they are put back onto the patch. What they sweep at an inlet is new, what is beyond an outlet has left.

#include "conditions/boundaryConditions.hpp"
#include "state/state.hpp"
#include "walls/controls.hpp"

namespace pfem {

/// The step from t0 to t1 that moved the nodes from xOld, with the topology that it had.
template <int Dim>
struct PassageStep {
    const BoundaryConditions<Dim>& conditions;
    const Topology<Dim>& topology;
    const Points<Dim>& xOld;
    double t0, t1;
};

/// Nodes where a wall goes over smoothly into an inlet belong to the inlet: the lips of a sluice in a plane wall.
template <int Dim>
void holdAtLips(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, Nodes<Dim>& nodes);

/// Put the nodes that inlets drive back. The volume that comes in is the prescribed one; what the mesh gained beside it
/// (where the surface slopes at an inlet that is not full) is booked as the solver's, and taken from what nodes lack.
/// Other water that comes within landingDistance h is held there as by a wall.
template <int Dim>
void drawFromInlets(const PassageStep<Dim>& step, const WallDistances& controls, State<Dim>& state);

/// Put nodes beyond outlets back onto them, along the walls that hold them, too; at the free surface to where it
/// crosses the patch. Their velocity is that of the moved water at this place; where water turns back it keeps its
/// own. Nodes that cross it arrive there. Drops that cross an outlet leave: returned.
/// What leaves takes its part of lostVolume along.
template <int Dim>
std::vector<int> letThroughOutlets(const PassageStep<Dim>& step, State<Dim>& state);

}  // namespace pfem
