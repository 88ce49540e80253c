#pragma once
// How inlets drive the nodes that are on them: like a piston that bends. The step is Lagrangian there as everywhere;
// after it the nodes are put back onto the patch (walls/openings.hpp), and what they swept is new water.

#include <functional>

#include "conditions/boundaryConditions.hpp"
#include "state/images.hpp"

namespace pfem {

/// How the water of an inlet is spread over the patch with these faces, at time t.
template <int Dim>
struct InletSpread {
    Vec<Dim> direction;                            // unit vector, into the fluid
    std::function<double(const Vec<Dim>&)> speed;  // at a place, up to a factor
};
template <int Dim>
InletSpread<Dim> inletSpread(const Inlet& inlet, const std::vector<Face<Dim>>& faces, const Points<Dim>& x, double t);

/// A node that an inlet drives.
template <int Dim>
struct DrivenNode {
    int node;
    RigidStep<Dim> motion;  // a translation
    bool pinned;            // wholly; else (the free surface at an inlet that is not full) only across the patch
};

/// The inlet patch that holds a node, -1: none.
template <int Dim>
int inletOf(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, int node);

/// Nodes at lips: on an edge of an inlet that is no corner of the walls (a free end, or a wall that goes on smoothly),
/// where the stream's surface begins.
template <int Dim>
std::vector<int> lipNodes(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology,
                          const Nodes<Dim>& nodes);

/// What inlets do in a step.
template <int Dim>
struct Inflow {
    std::vector<DrivenNode<Dim>> driven;  // of ascending index, images of periodic sides among them
    double volume = 0;                    // that is to come in through wet faces, between such sides [m2 (2D), m3]
};

/// For the step from t0 to t1 of nodes at x (`nodes`: their names and sizes). With the speed u = c s e (s: shape, e:
/// direction) of the nodes, linear between them, c is such that the faces around them sweep the prescribed volume,
///     c sum_f |f|/Dim sum_{I in f} s_I e . n_f = flow rate        (velocity: flow rate = velocity times the wet area).
/// A node on a no-slip wall stays: s = 0. At the free surface a node is pinned on an edge of the patch (lips of a
/// nozzle), and slides up and down between.
template <int Dim>
Inflow<Dim> inflowOf(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Points<Dim>& x,
                     const Nodes<Dim>& nodes, double t0, double t1);

/// Largest speed over mesh size of the water that the inlets bring at time t, about: dry ones hold the step, too [1/s].
/// `period`: of an inlet that is drawn on beyond periodic sides, the part between them brings the flow rate.
template <int Dim>
double inletRate(const BoundaryConditions<Dim>& conditions, const Period<Dim>& period, const State<Dim>& state,
                 double t);

}  // namespace pfem
