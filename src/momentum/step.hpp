#pragma once
// What one step of time is about.

#include "conditions/constraints.hpp"
#include "conditions/problem.hpp"
#include "integration/midpointRule.hpp"

namespace pfem {

/// All that stays as it is while a step is iterated. A view: what it refers to must outlive it.
template <int Dim>
struct Step {
    const Problem<Dim>& problem;  // at the instant within the step at which the forces act
    const Mesh<Dim>& mesh;
    const Topology<Dim>& topology;
    const NodeConstraints<Dim>& constraints;
    const Nodes<Dim>& old;  // at t^n; their velocities obey the constraints
    MidpointRule midpoint;
    double divTarget = 0;  // wanted divergence of the fluid [1/s], 0 without volume correction

    double dt() const { return midpoint.dt; }
    double gamma() const { return midpoint.gamma; }
};

}  // namespace pfem
