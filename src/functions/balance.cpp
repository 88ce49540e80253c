#include "functions/balance.hpp"

#include "conditions/sides.hpp"
#include "momentum/consistentMass.hpp"
#include "momentum/mass.hpp"
#include "momentum/residual.hpp"

namespace pfem {

namespace {

/// The acceleration along periodic sides that the fluid's free nodes have beside all forces, on the average.
template <int Dim>
Vec<Dim> meanDrive(const Problem<Dim>& problem, const State<Dim>& state, const Topology<Dim>& topology,
                   const PerNode<double>& mass, const Points<Dim>& R) {
    const double now = state.time.value;
    const auto constraints = nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes, now, now);
    Vec<Dim> drive = Vec<Dim>::Zero();
    for (int k = 0; k < Dim; ++k) {
        if (problem.period.length[k] == 0) continue;
        double force = 0, moving = 0;
        for (int i = 0; i < nOwnNodes<Dim>(state); ++i) {
            if (!topology.wet(i) || topology.onSolid[i]) continue;
            const Vec<Dim> along = constraints.project(i, Vec<Dim>::Unit(k));
            force += along.dot(R[i]);
            moving += mass[i] * along[k];
        }
        if (moving > 0) drive[k] = force / moving;
    }
    return drive;
}

/// The residual of the momentum, and the acceleration of the force that holds the flow through periodic sides.
template <int Dim>
struct Balance {
    Points<Dim> R;
    Vec<Dim> drive = Vec<Dim>::Zero();
};

/// Of a state that is unfolded where there are periodic sides.
template <int Dim>
Balance<Dim> balanceOf(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    const auto& [mesh, nodes] = std::tie(state.mesh, state.nodes);
    const auto topology = makeTopology<Dim>(mesh, problem.conditions.kind, nodes.x, nodes.wall);
    const FluidPhase<Dim> fluid(problem, mesh, topology.fluid, nodes, controls.fluidScheme());
    const SolidPhase<Dim> solid(problem, controls.solid, mesh, topology.solid, nodes, controls.solidScheme());
    auto external = externalForce<Dim>(mesh, topology, fluid, nodes);
    const auto viscous = viscousForces<Dim>(fluid, controls.momentum.waveDamping, nodes);
    for (int i = 0; i < nodes.size(); ++i) external[i] -= viscous[i];
    auto R = momentumResidual<Dim>(nodalMass<Dim>(fluid, solid), nodes, fluid, solid, external, 1);
    if (controls.momentum.fluidMass() == FluidMass::consistent) addMassDifference<Dim>(fluid, 1, nodes.a, R);
    Balance<Dim> balance;
    if (problem.flow) {
        const auto mass = fluidMass<Dim>(problem, mesh.fluid, fluid.domains);
        balance.drive = meanDrive<Dim>(problem, state, topology, mass, R);
        for (int i = 0; i < nodes.size(); ++i) R[i] -= mass[i] * balance.drive;
    }
    const double now = state.time.value;
    if (!topology.rides.empty())
        handOver<Dim>(nodeConstraints<Dim>(mesh, problem.conditions, topology, nodes, now, now).riders, R);
    balance.R = std::move(R);
    return balance;
}

/// Of any state.
template <int Dim>
Balance<Dim> balanceNow(const Problem<Dim>& problemOfRun, const Controls& controls, const State<Dim>& state) {
    const Problem<Dim> problem = problemAt<Dim>(state.time.value, problemOfRun);
    if (!problem.period.any()) return balanceOf<Dim>(problem, controls, state);
    return balanceOf<Dim>(problem, controls, unfolded<Dim>(sidesOf<Dim>(problem, state), state));
}

}  // namespace

template <int Dim>
Points<Dim> supportForces(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    auto R = balanceNow<Dim>(problem, controls, state).R;
    if (!problem.period.any()) return R;
    R.resize(nOwnNodes<Dim>(state));
    R.resize(state.nodes.size(), Vec<Dim>::Zero());  // images count with their masters
    return R;
}

template <int Dim>
Vec<Dim> driveOf(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state) {
    return problem.flow ? balanceNow<Dim>(problem, controls, state).drive : Vec<Dim>(Vec<Dim>::Zero());
}

#define PFEM_INSTANTIATE(D)                                                                   \
    template Points<D> supportForces<D>(const Problem<D>&, const Controls&, const State<D>&); \
    template Vec<D> driveOf<D>(const Problem<D>&, const Controls&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
