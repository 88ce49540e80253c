#include "functions/controlVolume.hpp"

#include <algorithm>
#include <cmath>

#include "functions/balance.hpp"
#include "functions/faceForce.hpp"
#include "functions/fluidMasses.hpp"
#include "mesh/simplex.hpp"
#include "momentum/mass.hpp"
#include "momentum/residual.hpp"
#include "momentum/wallFriction.hpp"
#include "state/images.hpp"

namespace pfem {

namespace {

template <int Dim>
std::vector<double> weights(const ControlVolume<Dim>& volume, const Points<Dim>& x) {
    std::vector<double> w;
    for (const auto& place : x) w.push_back(volume.weight(place));
    return w;
}

/// What passes the layers: cells with a gradient of the weight.
template <int Dim>
void addFlows(const Problem<Dim>& problem, const State<Dim>& state, const ControlVolume<Dim>& volume,
              const std::vector<double>& w, MomentumRates& rates) {
    const auto& nodes = state.nodes;
    const auto& cells = state.mesh.fluid;
    for (int e = 0; e < nOwnCells<Dim>(state); ++e) {
        const auto& cell = cells.nodes[e];
        if (std::all_of(cell.begin(), cell.end(), [&](int i) { return w[i] == w[cell[0]]; })) continue;
        const auto g = simplexGeometry<Dim>(nodes.x, cell);
        Vec<Dim> slope = Vec<Dim>::Zero();
        for (std::size_t k = 0; k <= Dim; ++k) slope += w[cell[k]] * g.gradN[k];
        double flow = 0, pressure = 0;
        for (const int i : cell) {
            flow += g.measure / (Dim + 1) * problem.fluid(cells.material[e]).rho * volume.direction.dot(nodes.v[i]) *
                    slope.dot(nodes.v[i]);
            pressure += g.measure / (Dim + 1) * nodes.p[i] * volume.direction.dot(slope);
        }
        const bool near = volume.isNearFrom(simplexCentroid<Dim>(nodes.x, cell));
        (near ? rates.flowFrom : rates.flowTo) += flow;
        (near ? rates.pressureFrom : rates.pressureTo) += pressure;
    }
}

/// Forces of walls and solids on the fluid.
template <int Dim>
void addWalls(const Problem<Dim>& problem, const State<Dim>& state, const Topology<Dim>& topology,
              const ControlVolume<Dim>& volume, const std::vector<double>& w, MomentumRates& rates) {
    for (const auto& face : wetFaces<Dim>(state, topology)) {
        if (std::all_of(face.nodes.begin(), face.nodes.end(), [&](int i) { return w[i] == 0; })) continue;
        const auto force = faceForce<Dim>(problem, state, face);
        for (std::size_t k = 0; k < Dim; ++k)
            rates.walls -= w[face.nodes[k]] * volume.direction.dot(force.pressure[k] + force.viscous[k]);
    }
}

}  // namespace

template <int Dim>
double ControlVolume<Dim>::weight(const Vec<Dim>& x) const {
    const double s = direction.dot(x - from);
    return std::clamp(std::min(s, length - s) / width + 0.5, 0.0, 1.0);
}

template <int Dim>
double momentumIn(const Problem<Dim>& problem, const State<Dim>& state, const ControlVolume<Dim>& volume) {
    const auto mass = withDrops<Dim>(problem, state, massOfCells<Dim>(problem, state));
    double sum = 0;
    for (int i = 0; i < state.nodes.size(); ++i)
        sum += mass[i] * volume.weight(state.nodes.x[i]) * volume.direction.dot(state.nodes.v[i]);
    return sum;
}

template <int Dim>
MomentumRates momentumRates(const Problem<Dim>& problemOfRun, const Controls& controls, const State<Dim>& state,
                            const ControlVolume<Dim>& volume) {
    const Problem<Dim> problem = problemAt<Dim>(state.time.value, problemOfRun);
    const auto& [mesh, nodes] = std::tie(state.mesh, state.nodes);
    const auto w = weights<Dim>(volume, nodes.x);
    const auto topology = makeTopology<Dim>(mesh, problem.conditions.kind, nodes.x, nodes.wall);
    MomentumRates rates;
    addFlows<Dim>(problem, state, volume, w, rates);
    addWalls<Dim>(problem, state, topology, volume, w, rates);
    const FluidPhase<Dim> fluid(problem, mesh, topology.fluid, nodes, controls.fluidScheme());
    const auto viscous = viscousForces<Dim>(fluid, controls.momentum.waveDamping, nodes);
    Points<Dim> around(nodes.size(), Vec<Dim>::Zero());
    addSideFriction<Dim>(problem, mesh.fluid, fluid.domains, nodes.v, around);
    addDamping<Dim>(problem, mesh.fluid, fluid.domains, nodes, around);
    const auto driven = massOfCells<Dim>(problem, state);  // drops are not
    const auto mass = withDrops<Dim>(problem, state, driven);
    const Vec<Dim> drive = driveOf<Dim>(problem, controls, state);
    for (int i = 0; i < nodes.size(); ++i) {
        rates.viscous += w[i] * volume.direction.dot(around[i] - viscous[i]);
        rates.gravity += w[i] * volume.direction.dot(mass[i] * problem.gravity + driven[i] * drive);
    }
    return rates;
}

#define PFEM_INSTANTIATE(D)                                                                      \
    template struct ControlVolume<D>;                                                            \
    template double momentumIn<D>(const Problem<D>&, const State<D>&, const ControlVolume<D>&);  \
    template MomentumRates momentumRates<D>(const Problem<D>&, const Controls&, const State<D>&, \
                                            const ControlVolume<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
