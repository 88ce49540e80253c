#pragma once
// Physics and boundary conditions; gravity and tractions may depend on time.

#include "conditions/constraints.hpp"
#include "conditions/contact.hpp"
#include "conditions/heldFlow.hpp"
#include "material/material.hpp"

namespace pfem {

template <int Dim>
struct Problem {
    std::vector<Material> materials;                // in the order of Mesh::materials
    double time = 0;                                // the time in question [s]
    Vec<Dim> gravity = Vec<Dim>::Zero();            // at the time in question [m/s2]
    Function1Ptr<Eigen::Vector3d> gravityOverTime;  // null: it stays as it is
    BoundaryConditions<Dim> conditions;
    ContactConditions contact;
    Period<Dim> period;                    // of periodic sides
    std::shared_ptr<const HeldFlow> flow;  // through them that a body force holds; null: what gravity drives

    const ViscousFluid& fluid(int material) const { return materials[material].fluid; }
    const Solid& solid(int material) const { return materials[material].solid; }
};

/// The problem with gravity and tractions of time t [s].
template <int Dim>
Problem<Dim> problemAt(double t, Problem<Dim> problem) {
    problem.time = t;
    if (problem.gravityOverTime) problem.gravity = problem.gravityOverTime->value(t).template head<Dim>();
    BoundaryConditions<Dim>& c = problem.conditions;
    for (std::size_t k = 0; k < c.tractionOverTime.size(); ++k)
        if (c.tractionOverTime[k]) c.traction[k] = c.tractionOverTime[k]->value(t).template head<Dim>();
    return problem;
}

}  // namespace pfem
