#include "solver/solidImpact.hpp"

#include "momentum/solidPhase.hpp"
#include "solver/momentumEquation.hpp"

namespace pfem {

namespace {

/// The twist that the body's nodes have.
template <int Dim>
Twist<Dim> twistOf(const RigidBody<Dim>& body, const Points<Dim>& v) {
    Points<Dim> levers, own;
    for (std::size_t k = 0; k < body.nodes.size(); ++k) {
        levers.push_back(body.pose.lever(body.arm[k]));
        own.push_back(v[body.nodes[k]]);
    }
    return nearestTwist<Dim>(levers, own);
}

}  // namespace

template <int Dim>
bool stopStruckSolids(const Step<Dim>& step, const Controls& controls, NodeConstraints<Dim>& constraints,
                      Nodes<Dim>& nodes) {
    if (!step.contacts || step.contacts->empty()) return false;
    ContactForces<Dim> contact(*step.contacts, step.dt(), 0);
    if (!contact.strikes(nodes.v)) return false;
    const FluidPhase<Dim> fluid(step.problem, step.mesh, step.topology.fluid, nodes, controls.fluidScheme());
    const SolidPhase<Dim> solid(step.problem, controls.solid, step.mesh, step.topology.solid, nodes,
                                controls.solidScheme());
    const MomentumEquation<Dim> momentum(step, controls, fluid, solid);
    contact.stop(momentum.system(), nodes.v);
    for (auto& body : constraints.bodies) body.twist = twistOf<Dim>(body, nodes.v);
    return true;
}

template bool stopStruckSolids<2>(const Step<2>&, const Controls&, NodeConstraints<2>&, Nodes<2>&);
template bool stopStruckSolids<3>(const Step<3>&, const Controls&, NodeConstraints<3>&, Nodes<3>&);

}  // namespace pfem
