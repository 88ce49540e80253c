#include "functions/balance.hpp"

#include "momentum/consistentMass.hpp"
#include "momentum/residual.hpp"

namespace pfem {

template <int Dim>
Points<Dim> supportForces(const Problem<Dim>& problemOfRun, const Controls& controls, const State<Dim>& state) {
    const Problem<Dim> problem = problemAt<Dim>(state.time.value, problemOfRun);
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

#define PFEM_INSTANTIATE(D) template Points<D> supportForces<D>(const Problem<D>&, const Controls&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
