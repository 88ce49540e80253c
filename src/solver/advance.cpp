#include "solver/advance.hpp"

#include <chrono>

#include "remesh/penetration.hpp"
#include "remesh/wallContact.hpp"
#include "solver/invariants.hpp"

namespace pfem {

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Divergence that brings the volume back to its first value within `time`, but no faster than within the step.
template <int Dim>
double volumeCorrection(const State<Dim>& state, double time, double dt) {
    if (time == 0) return 0;
    const double volume = totalVolume<Dim>(state);
    double change = 0;
    for (const auto& [cause, amount] : state.ledger) change += amount;
    return volume > 0 ? -change / (volume * std::max(time, dt)) : 0;
}

/// Velocities and accelerations that the constraints allow.
template <int Dim>
void obeyConstraints(const NodeConstraints<Dim>& constraints, Nodes<Dim>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        nodes.v[i] = constraints.project(i, nodes.v[i]);
        nodes.a[i] = constraints.project(i, nodes.a[i]);
    }
}

template <int Dim>
double fluidDensity(const Problem<Dim>& problem) {
    double rho = 0;
    for (const auto& material : problem.materials)
        if (material.kind == MaterialKind::fluid) rho = std::max(rho, material.fluid.rho);
    return rho;
}

/// The state after a step of report.dt with its new connectivity. Throws FailedStep when it cannot be accepted.
template <int Dim>
State<Dim> attempt(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& last,
                   AdvanceReport& report) {
    State<Dim> state = last;
    report.mesh = {};
    const double start = now();
    const auto& kinds = problem.conditions.kind;
    const auto topology = makeTopology<Dim>(state.mesh, kinds, state.nodes.wall);
    const auto constraints = nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes);
    obeyConstraints<Dim>(constraints, state.nodes);

    const double volume = cellVolume<Dim>(state.nodes.x, state.mesh.fluid.nodes);
    const double divTarget = volumeCorrection<Dim>(state, controls.continuity.volumeCorrectionTime, report.dt);
    auto result = fsiStep<Dim>(problem, controls, state.mesh, topology, constraints, state.nodes, report.dt, divTarget);
    report.step = result.report;
    const std::vector<int> wallsOld = state.nodes.wall;
    const Points<Dim> xOld = std::move(state.nodes.x);
    state.nodes = std::move(result.nodes);
    state.mesh.solid.sigma = std::move(result.cellSigma);

    const double moved = cellVolume<Dim>(state.nodes.x, state.mesh.fluid.nodes);
    const double correction = divTarget * volume * report.dt;
    state.ledger["correction"] += correction;
    state.ledger["solver"] += moved - volume - correction;
    const double stepped = now();
    report.seconds[0] += stepped - start;

    try {
        releaseFromWalls<Dim>(controls.remeshing, topology, problem.gravity, fluidDensity<Dim>(problem), state.nodes);
        state.ledger["released"] += cellVolume<Dim>(state.nodes.x, state.mesh.fluid.nodes) - moved;
        landOnWalls<Dim>(controls.remeshing, topology, xOld, state);
        report.returned = returnPenetrating<Dim>(topology, controls.remeshing.wallDistance, state);
        const auto& cells = state.mesh.fluid.nodes;
        const bool wallsChanged = wallsOld != state.nodes.wall || report.returned > 0;
        if (wallsChanged || isDistorted(controls.remeshing.distortion, state.nodes.x, cells))
            report.mesh = remesh<Dim>(controls.remeshing, kinds,
                                      wallsOld == state.nodes.wall
                                          ? topology
                                          : makeTopology<Dim>(state.mesh, kinds, state.nodes.wall),
                                      report.dt, state);
    } catch (const StepFailure& failure) {  // the new mesh is unfinished
        throw FailedStep<Dim>(failure, withNodesOf<Dim>(last, state.nodes));
    }
    try {
        checkInvariants<Dim>(controls.convergence, topology, last, state);
    } catch (const StepFailure& failure) {
        throw FailedStep<Dim>(failure, std::move(state));
    }
    report.seconds[1] += now() - stepped;
    return state;
}

}  // namespace

template <int Dim>
std::pair<double, double> courantRate(const State<Dim>& state) {
    double largest = 0, sum = 0;
    for (int i = 0; i < state.nodes.size(); ++i) {
        const double rate = state.nodes.v[i].norm() / state.nodes.h[i];
        largest = std::max(largest, rate);
        sum += rate;
    }
    return {largest, state.nodes.size() > 0 ? sum / state.nodes.size() : 0};
}

template <int Dim>
AdvanceReport advance(const Problem<Dim>& problem, const Controls& controls, State<Dim>& last, double dt) {
    AdvanceReport report;
    const auto& limits = controls.convergence;
    checkSpeed<Dim>(limits, last.nodes);
    for (report.dt = dt;; report.dt *= 0.5) {
        try {
            State<Dim> next = attempt<Dim>(problem, controls, last, report);
            last = std::move(next);
            return report;
        } catch (const StepFailure& failure) {  // `last` stays as it was
            ++report.rejected;
            report.reasons.push_back(failure.what());
            if (report.rejected > limits.maxHalvings || 0.5 * report.dt < limits.deltaTMin) throw;
        }
    }
}

template <int Dim>
void startConsistently(const Problem<Dim>& problem, const Controls& controls, State<Dim>& state, double dt) {
    const auto topology = makeTopology<Dim>(state.mesh, problem.conditions.kind, state.nodes.wall);
    const auto constraints = nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes);
    obeyConstraints<Dim>(constraints, state.nodes);
    try {
        state.nodes =
            consistentStart<Dim>(problem, controls, state.mesh, topology, constraints, state.nodes, dt);
    } catch (const StepFailure& failure) {
        throw StepFailure("The pressure at the start cannot be computed; are the physical constants, their units and "
                          "the factors in system/pfemSolution sound?\n" +
                          std::string(failure.what()));
    }
}

#define PFEM_INSTANTIATE(D)                                                                                  \
    template std::pair<double, double> courantRate<D>(const State<D>&);                                      \
    template AdvanceReport advance<D>(const Problem<D>&, const Controls&, State<D>&, double);                \
    template void startConsistently<D>(const Problem<D>&, const Controls&, State<D>&, double);
PFEM_INSTANTIATE(2)

}  // namespace pfem
