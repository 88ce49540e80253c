#pragma once
// What one step of time is about.

#include "conditions/constraints.hpp"
#include "conditions/problem.hpp"
#include "integration/midpointRule.hpp"
#include "state/images.hpp"
#include "walls/solidContact.hpp"

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
    double divTarget = 0;                 // wanted divergence of the fluid [1/s], 0 without volume correction
    const Images<Dim>* images = nullptr;  // beyond periodic sides; null: there are none
    const std::vector<ContactPair<Dim>>* contacts = nullptr;  // that solids may make; null: none

    /// Images get what their masters have.
    template <class Value>
    void follow(std::vector<Value>& values) const {
        if (images) images->follow(values);
    }
    bool isImage(int node) const { return images && images->isImage(node); }
    int own(int node) const { return images ? images->own(node) : node; }

    double dt() const { return midpoint.dt; }
    double gamma() const { return midpoint.gamma; }
};

}  // namespace pfem
