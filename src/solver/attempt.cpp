#include "solver/attempt.hpp"

#include <algorithm>
#include <chrono>

#include "conditions/sides.hpp"
#include "continuity/compression.hpp"
#include "continuity/residual.hpp"
#include "momentum/meniscus.hpp"
#include "remesh/motionAccount.hpp"
#include "solver/beginStep.hpp"
#include "solver/fluidEnergy.hpp"
#include "solver/invariants.hpp"
#include "solver/remeshingRules.hpp"
#include "solver/solidImpact.hpp"

namespace pfem {

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Divergence that brings the volume back to its first value within `time`, but no faster than within the step.
template <int Dim>
double volumeCorrection(const State<Dim>& state, double time, double dt) {
    if (time == 0) return 0;
    const double volume = totalVolume<Dim>(state);
    return volume > 0 ? -state.ledger.sum(CauseKind::gainOrLoss) / (volume * std::max(time, dt)) : 0;
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

/// The fluid's cells that count.
template <int Dim>
Cells<Dim> countedCells(const State<Dim>& state) {
    Cells<Dim> cells = state.mesh.fluid;
    cells.nodes.resize(nOwnCells<Dim>(state));
    return cells;
}

/// Algorithm 1 but for its last line: the nodes move, the connectivity stays. `problem`: that of the step's end,
/// `within`: that of the time at which the momentum equation holds.
template <int Dim>
Motion<Dim> move(const Problem<Dim>& problem, const Problem<Dim>& within, const Controls& controls,
                 const State<Dim>& last, AdvanceReport& report, State<Dim>& state) {
    Motion<Dim> motion;
    motion.dt = report.dt;
    const auto images = imagesOf<Dim>(state);
    auto [topologyOfStep, constraints] = beginStep<Dim>(problem, report.dt, state, controls.continuity.ranks);
    images.follow(state.nodes.v);
    images.follow(state.nodes.a);
    motion.topology = std::move(topologyOfStep);
    const Topology<Dim>& topology = motion.topology;
    const FluidMass mass = controls.momentum.fluidMass();
    if (state.nodes.v != last.nodes.v)  // what has landed moves on as its wall allows
        state.energy.book(EnergyCause::remeshing, fluidEnergy<Dim>(problem, state, mass).total() -
                                                      fluidEnergy<Dim>(problem, last, mass).total());

    MotionAccount<Dim> account(state, controls.continuity.ranks);
    const double divTarget = volumeCorrection<Dim>(state, controls.continuity.volumeCorrectionTime, report.dt);
    const MidpointRule midpoint{report.dt, controls.timeIntegration.gamma};
    const auto nearby = [&] { return contactPairs<Dim>(within, state.mesh, topology, state.nodes, report.dt); };
    auto contacts = nearby();
    const Step<Dim> step{within,      state.mesh, topology,  constraints,
                         state.nodes, midpoint,   divTarget, images.empty() ? nullptr : &images,
                         &contacts};
    if (stopStruckSolids<Dim>(step, controls, constraints, state.nodes)) contacts = nearby();
    auto result = fsiStep<Dim>(step, controls);
    report.step = result.report;
    motion.wallsOld = state.nodes.wall;
    motion.returned = returnedVolume<Dim>(topology, state, report.dt * volumeReturnRate(controls.continuity, report.dt),
                                          report.dt * divTarget);
    const auto counted = images.empty() ? Cells<Dim>() : countedCells<Dim>(state);
    state.energy.book(EnergyCause::volume,
                      volumeEnergy<Dim>(problem, images.empty() ? state.mesh.fluid : counted, state.nodes, result.nodes,
                                        images.counted(motion.returned), mass) +
                          meniscusWork<Dim>(within, state.mesh.fluid, topology, state.nodes, result.nodes,
                                            controls.timeIntegration.gamma));
    motion.compressed = compressedVolume<Dim>(problem, state.mesh.fluid, topology.fluid, result.nodes, state.nodes.p,
                                              controls.continuity.ranks);
    motion.xOld = std::move(state.nodes.x);
    state.nodes = std::move(result.nodes);
    state.mesh.solid.sigma = std::move(result.cellSigma);
    state.mesh.solid.history = std::move(result.cellHistory);
    account.bookSolver(images.counted(motion.returned), images.counted(motion.compressed), state);
    return motion;
}

/// attempt() of a state that is unfolded where there are periodic sides.
template <int Dim>
State<Dim> attemptUnfolded(const Problem<Dim>& problemOfRun, const Controls& controls, Triangulator<Dim>& triangulator,
                           const State<Dim>& last, AdvanceReport& report) {
    const double t = last.time.value, end = t + report.dt;
    const auto problem = problemWithin<Dim>(end, t, end, problemOfRun),
               within = problemWithin<Dim>(t + controls.timeIntegration.gamma * report.dt, t, end, problemOfRun);
    State<Dim> state = last;
    report.mesh = {};
    const double start = now();
    const Motion<Dim> motion = move<Dim>(problem, within, controls, last, report, state);
    const double stepped = now();
    report.seconds[0] += stepped - start;
    const double allowed = allowedSpeed<Dim>(motion.topology, state.nodes);

    try {
        const auto outcome =
            runRules<Dim>(remeshingRules<Dim>(),
                          {problem, controls.remeshing, motion, triangulator, controls.momentum.fluidMass()}, state);
        report.returned = outcome.returned;
        if (outcome.connectivity) report.mesh = *outcome.connectivity;
    } catch (const StepFailure& failure) {  // the new mesh is unfinished
        throw FailedStep<Dim>(failure, withNodesOf<Dim>(last, state.nodes));
    }
    try {
        checkInvariants<Dim>(controls.convergence, motion.topology, last, state);
        checkSpeedGain<Dim>(allowed, state.nodes, last.nextId);
    } catch (const StepFailure& failure) {
        throw FailedStep<Dim>(failure, std::move(state));
    }
    report.seconds[1] += now() - stepped;
    return state;
}

}  // namespace

template <int Dim>
State<Dim> attempt(const Problem<Dim>& problem, const Controls& controls, Triangulator<Dim>& triangulator,
                   const State<Dim>& last, AdvanceReport& report) {
    if (!problem.period.any()) return attemptUnfolded<Dim>(problem, controls, triangulator, last, report);
    return folded<Dim>(attemptUnfolded<Dim>(problem, controls, triangulator,
                                            unfolded<Dim>(sidesOf<Dim>(problem, last), last), report));
}

#define PFEM_INSTANTIATE(D) \
    template State<D> attempt<D>(const Problem<D>&, const Controls&, Triangulator<D>&, const State<D>&, AdvanceReport&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
