#pragma once
// Physics and boundary conditions; gravity and tractions may depend on time. A case may be told in a frame that moves:
// whatever is in it has the acceleration of the frame, turned round, beside gravity. Still water outside has not, for
// it goes past with the velocity of the frame, turned round.

#include "conditions/constraints.hpp"
#include "conditions/contact.hpp"
#include "conditions/heldFlow.hpp"
#include "material/material.hpp"

namespace pfem {

template <int Dim>
struct Problem {
    std::vector<Material> materials;                // in the order of Mesh::materials
    double time = 0;                                // the time in question [s]
    Vec<Dim> gravity = Vec<Dim>::Zero();            // at the time in question, less what the frame has [m/s2]
    Function1Ptr<Eigen::Vector3d> gravityOverTime;  // that of the world; null: it stays as it is
    Function1Ptr<Eigen::Vector3d> frameOverTime;    // velocity of the frame [m/s]; null: it is at rest
    Vec<Dim> frameVelocity = Vec<Dim>::Zero();      // at the time in question
    Vec<Dim> frameAcceleration = Vec<Dim>::Zero();  // and its rate [m/s2]
    BoundaryConditions<Dim> conditions;
    ContactConditions contact;
    Period<Dim> period;                    // of periodic sides
    std::shared_ptr<const HeldFlow> flow;  // through them that a body force holds; null: what gravity drives

    Vec<Dim> gravityOutside() const { return gravity + frameAcceleration; }
    const ViscousFluid& fluid(int material) const { return materials[material].fluid; }
    const Solid& solid(int material) const { return materials[material].solid; }
};

/// The problem with gravity, frame and tractions of time t [s].
template <int Dim>
Problem<Dim> problemAt(double t, Problem<Dim> problem) {
    problem.time = t;
    Vec<Dim> gravity = problem.gravityOutside();
    if (problem.gravityOverTime) gravity = problem.gravityOverTime->value(t).template head<Dim>();
    if (problem.frameOverTime) {
        problem.frameVelocity = problem.frameOverTime->value(t).template head<Dim>();
        problem.frameAcceleration = problem.frameOverTime->derivative(t).template head<Dim>();
    }
    problem.gravity = gravity - problem.frameAcceleration;
    BoundaryConditions<Dim>& c = problem.conditions;
    for (std::size_t k = 0; k < c.tractionOverTime.size(); ++k)
        if (c.tractionOverTime[k]) c.traction[k] = c.tractionOverTime[k]->value(t).template head<Dim>();
    return problem;
}

}  // namespace pfem
