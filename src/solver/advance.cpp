#include "solver/advance.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "continuity/compression.hpp"
#include "continuity/residual.hpp"
#include "mesh/standing.hpp"
#include "remesh/giveWay.hpp"
#include "remesh/letGo.hpp"
#include "remesh/lostVolume.hpp"
#include "remesh/motionAccount.hpp"
#include "remesh/penetration.hpp"
#include "remesh/wallContact.hpp"
#include "solver/courantRate.hpp"
#include "solver/fluidEnergy.hpp"
#include "solver/impact.hpp"
#include "solver/invariants.hpp"

namespace pfem {

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Divergence that brings the volume back to its first value within `time`, but no faster than within the step.
template <int Dim>
double volumeCorrection(const State<Dim>& state, double time, double dt) {
    if (time == 0) return 0;
    const double volume = totalVolume<Dim>(state);
    return volume > 0 ? -state.ledger.gainsAndLosses() / (volume * std::max(time, dt)) : 0;
}

/// What a step is asked to give to each node's patch: a share of what the node lacks, and of the patch's volume.
template <int Dim>
std::vector<double> returnedVolume(const Topology<Dim>& topology, const State<Dim>& state, double ofLost,
                                   double ofPatch) {
    const auto& nodes = state.nodes;
    std::vector<double> returned(nodes.size(), 0.0);
    for (int i = 0; i < nodes.size(); ++i)
        if (topology.wet(i)) returned[i] = ofLost * nodes.lostVolume[i];
    if (ofPatch == 0) return returned;
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell) returned[i] += ofPatch * simplexMeasure<Dim>(nodes.x, cell) / (Dim + 1);
    return returned;
}

/// Constraints between two times [s] counted from the state's.
template <int Dim>
NodeConstraints<Dim> constraintsOver(double from, double to, const Problem<Dim>& problem, const State<Dim>& state,
                                     const Topology<Dim>& topology) {
    const double now = state.time.value;
    return nodeConstraints<Dim>(state.mesh, problem.conditions, topology, state.nodes, now + from, now + to);
}

/// Velocities and accelerations that the constraints of this instant allow.
template <int Dim>
void obeyConstraints(const NodeConstraints<Dim>& constraints, Nodes<Dim>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        nodes.v[i] = constraints.velocity(i, nodes.x[i], nodes.v[i]);
        if (!constraints.isMoved(i)) nodes.a[i] = constraints.project(i, nodes.a[i]);
    }
}

/// The topology for a step of length dt and velocities that its start allows. Walls that lift off leave their water.
template <int Dim>
Topology<Dim> beginStep(const Problem<Dim>& problem, double dt, State<Dim>& state) {
    const auto& kinds = problem.conditions.kind;
    auto topology = makeTopology<Dim>(state.mesh, kinds, state.nodes.wall);
    if (problem.conditions.anyMotion()) {
        const auto next = constraintsOver<Dim>(0, dt, problem, state, topology);
        Points<Dim> v = state.nodes.v;
        for (int i = 0; i < state.nodes.size(); ++i) v[i] = next.velocity(i, state.nodes.x[i], v[i]);
        if (leaveFeet(topology, v, state)) topology = makeTopology<Dim>(state.mesh, kinds, state.nodes.wall);
    }
    obeyConstraints<Dim>(constraintsOver<Dim>(0, 0, problem, state, topology), state.nodes);
    return topology;
}

/// Part of the lost volume for which the surface gives way in a step: all of it, but in steps of several periods of the
/// shortest waves, where it would come back in turns (doc/decisions.md).
template <int Dim>
double surfaceShare(const Problem<Dim>& problem, double dt, const Nodes<Dim>& nodes) {
    double h = std::numeric_limits<double>::max();
    for (const double size : nodes.h) h = std::min(h, size);
    return std::min(1.0, 10 * h / (problem.gravity.norm() * dt * dt));
}

/// Drops that are let go after the step.
template <int Dim>
std::vector<int> leavers(const Problem<Dim>& problem, const RemeshingControls& controls, const Topology<Dim>& topology,
                         const State<Dim>& state) {
    const bool steady = !problem.gravityOverTime || problem.gravityOverTime->isConstant();
    if (!controls.letGo || !steady) return {};
    return goneForGood<Dim>(topology, problem.gravity, problem.conditions.anyMotion(), state);
}

/// The densest fluid of the case.
template <int Dim>
ViscousFluid heaviestFluid(const Problem<Dim>& problem) {
    ViscousFluid result;
    result.rho = 0;
    for (const auto& material : problem.materials)
        if (material.kind == MaterialKind::fluid && material.fluid.rho > result.rho) result = material.fluid;
    return result;
}

/// The state after a step of report.dt with its new connectivity. Throws FailedStep when it cannot be accepted.
template <int Dim>
State<Dim> attempt(const Problem<Dim>& problemOfRun, const Controls& controls, Triangulator& triangulator,
                   const State<Dim>& last, AdvanceReport& report) {
    const Problem<Dim> problem = problemAt<Dim>(last.time.value + report.dt, problemOfRun);
    State<Dim> state = last;
    report.mesh = {};
    const double start = now();
    const auto& kinds = problem.conditions.kind;
    const auto topology = beginStep<Dim>(problem, report.dt, state);
    if (state.nodes.v != last.nodes.v)  // what has landed moves on as its wall allows
        state.energy.book(EnergyCause::remeshing,
                          fluidEnergy<Dim>(problem, state).total() - fluidEnergy<Dim>(problem, last).total());
    const auto constraints = constraintsOver<Dim>(0, report.dt, problem, state, topology);

    MotionAccount<Dim> account(state);
    const double divTarget = volumeCorrection<Dim>(state, controls.continuity.volumeCorrectionTime, report.dt);
    const auto problemWithin =
        problemAt<Dim>(last.time.value + controls.timeIntegration.gamma * report.dt, problemOfRun);
    auto result =
        fsiStep<Dim>(problemWithin, controls, state.mesh, topology, constraints, state.nodes, report.dt, divTarget);
    report.step = result.report;
    const std::vector<int> wallsOld = state.nodes.wall;
    const auto returned = returnedVolume<Dim>(
        topology, state, report.dt * volumeReturnRate(controls.continuity, report.dt), report.dt * divTarget);
    state.energy.book(EnergyCause::volume,
                      volumeEnergy<Dim>(problem, state.mesh.fluid, state.nodes, result.nodes, returned));
    const auto compressed =
        compressedVolume<Dim>(problem, state.mesh.fluid, topology.fluid, result.nodes, state.nodes.p);
    const Points<Dim> xOld = std::move(state.nodes.x);
    state.nodes = std::move(result.nodes);
    state.mesh.solid.sigma = std::move(result.cellSigma);

    account.bookSolver(returned, compressed, state);
    const double stepped = now();
    report.seconds[0] += stepped - start;
    const double energy = fluidEnergy<Dim>(problem, state).total(), allowed = allowedSpeed<Dim>(topology, state.nodes);

    try {
        if (problem.conditions.anyMotion()) standOnWalls(state.mesh, wallPatches(kinds), state.nodes);
        giveWay<Dim>(controls.remeshing, topology, returned, surfaceShare<Dim>(problem, report.dt, state.nodes), state);
        account.book(VolumeCause::surface, state);
        releaseFromWalls<Dim>(controls.remeshing, topology, problem.gravity, heaviestFluid<Dim>(problem), report.dt,
                              state.nodes);
        account.book(VolumeCause::released, state);
        landOnWalls<Dim>(controls.remeshing, topology, xOld, state);
        account.book(VolumeCause::landed, state);
        report.returned = returnPenetrating<Dim>(topology, controls.remeshing.wallDistance, state);
        if (!state.mesh.solid.nodes.empty()) account.book(VolumeCause::returned, state);
        const auto& cells = state.mesh.fluid.nodes;
        for (int i = 0; i < state.nodes.size(); ++i) state.nodes.lostVolume[i] += compressed[i];  // is not lost
        chargeMotion<Dim>(topology.fluid, cells, xOld, state.nodes);
        const bool wallsChanged = wallsOld != state.nodes.wall || report.returned > 0;
        if (wallsChanged || isDistorted(controls.remeshing.distortion, state.nodes.x, cells)) {
            const auto remeshed = remesh<Dim>(
                controls.remeshing, kinds,
                wallsOld == state.nodes.wall ? topology : withWalls<Dim>(state.mesh, kinds, state.nodes.wall, topology),
                report.dt, triangulator, state, leavers<Dim>(problem, controls.remeshing, topology, state));
            const double met = closingRate<Dim>(state.nodes, remeshed.contacts, controls.remeshing.contactHeight);
            strike<Dim>(problem, remeshed.contacts, state);
            state.approach = std::max(met, closingRate<Dim>(state.nodes, remeshed.gaps, 0));
            report.mesh = remeshed;
        }
        state.energy.book(EnergyCause::remeshing, fluidEnergy<Dim>(problem, state).total() - energy);
    } catch (const StepFailure& failure) {  // the new mesh is unfinished
        throw FailedStep<Dim>(failure, withNodesOf<Dim>(last, state.nodes));
    }
    try {
        checkInvariants<Dim>(controls.convergence, topology, last, state);
        checkSpeedGain<Dim>(allowed, state.nodes);
    } catch (const StepFailure& failure) {
        throw FailedStep<Dim>(failure, std::move(state));
    }
    report.seconds[1] += now() - stepped;
    return state;
}

}  // namespace

template <int Dim>
AdvanceReport advance(const Problem<Dim>& problem, const Controls& controls, Triangulator& triangulator,
                      State<Dim>& last, double dt) {
    AdvanceReport report;
    const auto& limits = controls.convergence;
    checkSpeed<Dim>(limits, last.nodes);
    for (report.dt = dt;; report.dt *= 0.5) {
        try {
            State<Dim> next = attempt<Dim>(problem, controls, triangulator, last, report);
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
    const auto topology = beginStep<Dim>(problem, dt, state);
    const auto over = [&](double from, double to) { return constraintsOver<Dim>(from, to, problem, state, topology); };
    state.nodes = consistentStart<Dim>(problemAt<Dim>(state.time.value, problem), controls, state.mesh, topology, over,
                                       state.nodes, 1e-3 * dt);
}

#define PFEM_INSTANTIATE(D)                                                                                  \
    template AdvanceReport advance<D>(const Problem<D>&, const Controls&, Triangulator&, State<D>&, double); \
    template void startConsistently<D>(const Problem<D>&, const Controls&, State<D>&, double);
PFEM_INSTANTIATE(2)

}  // namespace pfem
