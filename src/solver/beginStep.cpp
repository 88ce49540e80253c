#include "solver/beginStep.hpp"

#include <cmath>

#include "conditions/rigidBodies.hpp"
#include "mesh/contacts.hpp"
#include "mesh/sharedTopology.hpp"

namespace pfem {

namespace {

/// What has slid round a bend goes on as fast as before: its velocity turns with the wall.
template <int Dim>
Vec<Dim> turned(const Vec<Dim>& before, const Vec<Dim>& along) {
    const double speed = before.norm(), part = along.norm();
    const bool bent = (before - along).norm() > 1e-12 * speed;
    return bent && part > std::cos(featureAngle * M_PI / 180) * speed ? Vec<Dim>(along * (speed / part)) : along;
}

/// Velocities and accelerations that the constraints of this instant allow. What rides on a solid keeps what it brings
/// along: the step takes it off and gives its momentum to the solid.
template <int Dim>
void obeyConstraints(const Topology<Dim>& topology, const NodeConstraints<Dim>& constraints, Nodes<Dim>& nodes) {
    Points<Dim> brought;
    for (const auto& rider : constraints.riders) brought.push_back(rider.own(nodes.v[rider.ride.node]));
    for (int i = 0; i < nodes.size(); ++i) {
        const Vec<Dim> before = nodes.v[i];
        nodes.v[i] = constraints.velocity(i, nodes.x[i], before);
        if (topology.onWall[i] && !constraints.isMoved(i)) nodes.v[i] = turned<Dim>(before, nodes.v[i]);
        if (!constraints.isMoved(i)) nodes.a[i] = constraints.project(i, nodes.a[i]);
    }
    for (std::size_t k = 0; k < brought.size(); ++k) nodes.v[constraints.riders[k].ride.node] += brought[k];
    for (const auto& body : constraints.bodies)
        for (std::size_t k = 0; k < body.nodes.size(); ++k)
            nodes.v[body.nodes[k]] = leverRows<Dim>(body.pose.lever(body.arm[k])) * body.twistAt(body.pose, body.twist);
}

}  // namespace

template <int Dim>
NodeConstraints<Dim> constraintsOver(double from, double to, const Problem<Dim>& problem, const State<Dim>& state,
                                     const Topology<Dim>& topology) {
    const double now = state.time.value;
    auto constraints =
        nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes, now + from, now + to);
    addRigidBodies<Dim>(problem, state.mesh, state.nodes, constraints);
    return constraints;
}

template <int Dim>
StepStart<Dim> beginStep(const Problem<Dim>& problem, double dt, State<Dim>& state, const Ranks& ranks) {
    const auto& conditions = problem.conditions;
    StepStart<Dim> start;
    start.topology = makeTopology<Dim>(state.mesh, conditions.kind, state.nodes.x, state.nodes.wall, ranks);
    if (problem.contact.on)
        start.topology =
            withContacts<Dim>(state.mesh, conditions.kind, state.nodes.x, state.nodes.wall, std::move(start.topology));
    start.constraints = constraintsOver<Dim>(0, 0, problem, state, start.topology);
    obeyConstraints<Dim>(start.topology, start.constraints, state.nodes);
    if (conditions.anyMotion() || conditions.anyInlet() || !start.constraints.riders.empty())  // else ever the same
        start.constraints = constraintsOver<Dim>(0, dt, problem, state, start.topology);
    return start;
}

#define PFEM_INSTANTIATE(D)                                                                            \
    template NodeConstraints<D> constraintsOver<D>(double, double, const Problem<D>&, const State<D>&, \
                                                   const Topology<D>&);                                \
    template StepStart<D> beginStep<D>(const Problem<D>&, double, State<D>&, const Ranks&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
