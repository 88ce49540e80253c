#include "solver/beginStep.hpp"

#include "walls/tJunctions.hpp"

namespace pfem {

namespace {

/// Velocities and accelerations that the constraints of this instant allow.
template <int Dim>
void obeyConstraints(const NodeConstraints<Dim>& constraints, Nodes<Dim>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        nodes.v[i] = constraints.velocity(i, nodes.x[i], nodes.v[i]);
        if (!constraints.isMoved(i)) nodes.a[i] = constraints.project(i, nodes.a[i]);
    }
}

}  // namespace

template <int Dim>
NodeConstraints<Dim> constraintsOver(double from, double to, const Problem<Dim>& problem, const State<Dim>& state,
                                     const Topology<Dim>& topology) {
    const double now = state.time.value;
    return nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes, now + from, now + to);
}

template <int Dim>
Topology<Dim> beginStep(const Problem<Dim>& problem, double dt, State<Dim>& state) {
    const auto& kinds = problem.conditions.kind;
    auto topology = makeTopology<Dim>(state.mesh, kinds, state.nodes.wall);
    if (problem.conditions.anyMotion()) {
        const auto next = constraintsOver<Dim>(0, dt, problem, state, topology);
        Points<Dim> v = state.nodes.v;
        for (int i = 0; i < state.nodes.size(); ++i) v[i] = next.velocity(i, state.nodes.x[i], v[i]);
        if (leaveTJunctions(topology, v, state)) topology = makeTopology<Dim>(state.mesh, kinds, state.nodes.wall);
    }
    obeyConstraints<Dim>(constraintsOver<Dim>(0, 0, problem, state, topology), state.nodes);
    return topology;
}

#define PFEM_INSTANTIATE(D)                                                                            \
    template NodeConstraints<D> constraintsOver<D>(double, double, const Problem<D>&, const State<D>&, \
                                                   const Topology<D>&);                                \
    template Topology<D> beginStep<D>(const Problem<D>&, double, State<D>&);
PFEM_INSTANTIATE(2)

}  // namespace pfem
