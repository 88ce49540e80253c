#include "functions/balance.hpp"

#include "momentum/fluidStress.hpp"
#include "momentum/residual.hpp"
#include "momentum/solidStress.hpp"

namespace pfem {

template <int Dim>
Points<Dim> supportForces(const Problem<Dim>& problemOfRun, const Controls& controls, const State<Dim>& state) {
    const Problem<Dim> problem = problemAt<Dim>(state.time.value, problemOfRun);
    const auto& mesh = state.mesh;
    const auto& nodes = state.nodes;
    const auto aroundFluid = nodeToCells<Dim>(mesh.fluid.nodes, nodes.size());
    const auto aroundSolid = nodeToCells<Dim>(mesh.solid.nodes, nodes.size());
    const Integration scheme = controls.integration.scheme();
    const auto fluid = makePatches<Dim>(mesh.fluid.nodes, aroundFluid, nodes.x, scheme);
    const auto solid = makePatches<Dim>(mesh.solid.nodes, aroundSolid, nodes.x, scheme);
    auto mass = fluidMass<Dim>(problem, mesh.fluid, fluid);
    const auto massOfSolid = solidMass<Dim>(problem, mesh.solid, nodes.X);
    for (std::size_t i = 0; i < mass.size(); ++i) mass[i] += massOfSolid[i];
    const auto mu = flowViscosity<Dim>(problem, mesh.fluid, fluid, nodes.v).mu;
    const auto viscous = viscousForce<Dim>(fluid, mu, nodes.v);
    auto external = tractionForce<Dim>(mesh, problem.conditions, nodes.x);
    for (int i = 0; i < nodes.size(); ++i) external[i] -= viscous[i];
    return momentumResidual<Dim>(mass, nodes.a, problem.gravity, fluid, nodes.p, solid,
                                 storedElementStress<Dim>(problem, controls.solid, mesh.solid, solid, nodes), external);
}

template Points<2> supportForces<2>(const Problem<2>&, const Controls&, const State<2>&);

}  // namespace pfem
