#include "functions/balance.hpp"

#include "conditions/sides.hpp"
#include "momentum/consistentMass.hpp"
#include "momentum/residual.hpp"

namespace pfem {

namespace {

/// The residual of the momentum, of a state that is unfolded where there are periodic sides.
template <int Dim>
Points<Dim> residualOf(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    const auto& [mesh, nodes] = std::tie(state.mesh, state.nodes);
    const auto topology = makeTopology<Dim>(mesh, problem.conditions.kind, nodes.x, nodes.wall);
    const Integration scheme = controls.integration.scheme();
    const FluidPhase<Dim> fluid(problem, mesh, topology.fluid, nodes, scheme);
    const SolidPhase<Dim> solid(problem, controls.solid, mesh, topology.solid, nodes, scheme);
    auto external = externalForce<Dim>(mesh, topology, fluid, nodes);
    const auto viscous = viscousForces<Dim>(fluid, controls.momentum.waveDamping, nodes);
    for (int i = 0; i < nodes.size(); ++i) external[i] -= viscous[i];
    auto R = momentumResidual<Dim>(nodalMass<Dim>(fluid, solid), nodes, fluid, solid, external, 1);
    if (controls.momentum.fluidMass() == FluidMass::consistent) addMassDifference<Dim>(fluid, 1, nodes.a, R);
    if (topology.rides.empty()) return R;
    const double now = state.time.value;
    handOver<Dim>(nodeConstraints<Dim>(mesh, problem.conditions, topology, nodes, now, now).riders, R);
    return R;
}

}  // namespace

template <int Dim>
Points<Dim> supportForces(const Problem<Dim>& problemOfRun, const Controls& controls, const State<Dim>& state) {
    const Problem<Dim> problem = problemAt<Dim>(state.time.value, problemOfRun);
    if (!problem.period.any()) return residualOf<Dim>(problem, controls, state);
    auto R = residualOf<Dim>(problem, controls, unfolded<Dim>(sidesOf<Dim>(problem, state), state));
    R.resize(nOwnNodes<Dim>(state));
    R.resize(state.nodes.size(), Vec<Dim>::Zero());  // images count with their masters
    return R;
}

#define PFEM_INSTANTIATE(D) template Points<D> supportForces<D>(const Problem<D>&, const Controls&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
