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

/// The frame with this velocity and acceleration; gravity outside stays.
template <int Dim>
void moveFrame(const Vec<Dim>& velocity, const Vec<Dim>& acceleration, Problem<Dim>& problem) {
    const Vec<Dim> outside = problem.gravityOutside();
    problem.frameVelocity = velocity;
    problem.frameAcceleration = acceleration;
    problem.gravity = outside - acceleration;
}

/// The problem with gravity, frame and tractions of time t [s].
template <int Dim>
Problem<Dim> problemAt(double t, Problem<Dim> problem) {
    problem.time = t;
    if (problem.gravityOverTime)
        problem.gravity = problem.gravityOverTime->value(t).template head<Dim>() - problem.frameAcceleration;
    if (problem.frameOverTime)
        moveFrame<Dim>(problem.frameOverTime->value(t).template head<Dim>(),
                       problem.frameOverTime->derivative(t).template head<Dim>(), problem);
    BoundaryConditions<Dim>& c = problem.conditions;
    for (std::size_t k = 0; k < c.tractionOverTime.size(); ++k)
        if (c.tractionOverTime[k]) c.traction[k] = c.tractionOverTime[k]->value(t).template head<Dim>();
    return problem;
}

/// The same at a time t of the step from t0 to t1, in which the frame has its mean acceleration: what it gets faster by
/// is not lost between.
template <int Dim>
Problem<Dim> problemWithin(double t, double t0, double t1, const Problem<Dim>& problemOfRun) {
    Problem<Dim> problem = problemAt<Dim>(t, problemOfRun);
    if (!problem.frameOverTime || !(t1 > t0)) return problem;
    const Eigen::Vector3d change = problem.frameOverTime->value(t1) - problem.frameOverTime->value(t0);
    moveFrame<Dim>(problem.frameVelocity, change.template head<Dim>() / (t1 - t0), problem);
    return problem;
}

}  // namespace pfem
