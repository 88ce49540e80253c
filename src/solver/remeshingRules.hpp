#pragma once
// The one door to new connectivity (Algorithm 1, line 13): what is done with the nodes that a step has moved, as a
// list of rules that run in their order.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conditions/problem.hpp"
#include "momentum/controls.hpp"
#include "remesh/remesh.hpp"

namespace pfem {

/// What a step has done to the nodes, with the connectivity that it had.
template <int Dim>
struct Motion {
    double dt = 0;                        // [s]
    Topology<Dim> topology;               // of the step's cells
    Points<Dim> xOld;                     // where the nodes were
    std::vector<Supports<Dim>> wallsOld;  // as Nodes::wall at the start
    std::vector<double> returned;         // volume that the continuity equation was asked to give to each node
    std::vector<double> compressed;       // volume that pressure has taken at each node, negative
};

/// What a rule may look at, besides the state.
template <int Dim>
struct RemeshingContext {
    const Problem<Dim>& problem;  // that of the step's end
    const RemeshingControls& controls;
    const Motion<Dim>& motion;
    Triangulator<Dim>& triangulator;  // has the triangulation of the step before, or none
    FluidMass mass = FluidMass::lumped;
};

/// What rules tell those after them, and the log.
template <int Dim>
struct RemeshingOutcome {
    int returned = 0;                               // nodes put back out of solids
    std::vector<int> leaving;                       // drops that are let go
    std::vector<int> pinched;                       // nodes between surfaces that have closed on them
    std::optional<RemeshReport<Dim>> connectivity;  // new, when it was made
};

/// A rule changes the state. The change of the fluid's volume by its motion is booked to its cause; that of a rule
/// without one together with the next rule that has one. New connectivity books its own causes.
template <int Dim>
struct RemeshingRule {
    using Run = std::function<void(const RemeshingContext<Dim>&, State<Dim>&, RemeshingOutcome<Dim>&)>;
    using Applies = std::function<bool(const RemeshingContext<Dim>&, const State<Dim>&)>;

    std::string name;
    std::optional<VolumeCause> cause;
    Run run;
    Applies applies = nullptr;  // always without
};

/// The rules of every step, in their order.
template <int Dim>
const std::vector<RemeshingRule<Dim>>& remeshingRules();

/// Run the rules that apply and book what they do, the energy as `remeshing`. Throws StepFailure; the state is then
/// unfinished.
template <int Dim>
RemeshingOutcome<Dim> runRules(const std::vector<RemeshingRule<Dim>>& rules, const RemeshingContext<Dim>& context,
                               State<Dim>& state);

}  // namespace pfem
