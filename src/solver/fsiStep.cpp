#include "solver/fsiStep.hpp"

#include "momentum/solidHistory.hpp"
#include "solver/continuityEquation.hpp"
#include "solver/convergence.hpp"
#include "solver/flowDrive.hpp"
#include "solver/momentumEquation.hpp"
#include "solver/scales.hpp"
#include "solver/shares.hpp"
#include "solver/stepChecks.hpp"

namespace pfem {

namespace {

/// The converged trial with its stress, when its domains are sound.
template <int Dim>
StepResult<Dim> accepted(FluidPhase<Dim>& fluid, SolidPhase<Dim>& solid, Trial<Dim>& trial, const StepReport& report) {
    fluid.moveTo(trial.end.x);
    updateSmoothingDomains<Dim>(solid.domains, trial.end.x);
    checkDomains<Dim>(fluid, solid, trial.end);
    StepResult<Dim> result{std::move(trial.end), {}, {}, report};
    storeHistory<Dim>(solid.domains, std::move(solid.stress.history), result.nodes.history, result.cellHistory);
    storeSolidStress<Dim>(solid.domains, std::move(solid.stress), result.nodes.sigma, result.cellSigma);
    return result;
}

/// Algorithm 1. `trial`: the first one on entry; what was reached when it throws.
template <int Dim>
StepResult<Dim> iterate(const Step<Dim>& step, const Controls& controls, Trial<Dim>& trial) {
    const Nodes<Dim>& old = step.old;
    const Share share = shareOf<Dim>(controls, step.mesh.fluid.nodes, step.topology.fluid);
    const bool ownRows = !share.isWhole() && hasOwnRows<Dim>(step, controls.continuity) && controls.momentum.theta == 0;
    FluidPhase<Dim> fluid(step.problem, step.mesh, step.topology.fluid, old, controls.fluidScheme(),
                          ownRows ? share : Share());
    SolidPhase<Dim> solid(step.problem, controls.solid, step.mesh, step.topology.solid, old, controls.solidScheme());
    MomentumEquation<Dim> momentum(step, controls, fluid, solid);
    ContinuityEquation<Dim> continuity(step, controls, fluid, momentum);
    FlowDrive<Dim> drive(step, fluid);
    const auto& tolerances = controls.convergence;
    Convergence convergence(tolerances, std::max(unseenSpeed<Dim>(step), roundOffSpeed<Dim>(step) / tolerances.tolU),
                            pressureScale<Dim>(step, fluid, tolerances.tolP));
    StepReport report;
    std::vector<double> dp;
    if (collapses<Dim>(fluid, trial.end.x)) fluid.wait(2);  // at x^n until there is a second velocity
    fluid.divide(share);
    fluid.moveTo(trial.middle.x);
    for (bool converged = false; !converged;) {
        if (report.iterations == controls.convergence.maxIterations)
            throw notConverged<Dim>(report, dp, trial.end, fluid.domains);
        const bool followed = fluid.follows;
        solid.moveTo(old, trial.end, step.dt());  // stresses
        fluid.flow(trial.middle.v);
        auto dv = momentum.solve(momentum.residual(trial, report.finalU), trial);  // R_m, (M + K) dv = -R_m
        drive.hold(momentum, trial, dv);                                           // the flow through periodic sides
        changeVelocity<Dim>(step, momentum.part(dv), dv, trial);                   // v, x, a
        fluid.moveTo(trial.middle.x);                                              // domains in the new configuration
        dp = continuity.solve(continuity.residual(trial), trial);                  // R_c, dp
        setExcess<Dim>(step, continuity.next(trial.excess, dp), trial);
        if (!followed && fluid.follows) continuity.restart();

        converged = convergence.reached(rms<Dim>(dv), rms<Dim>(trial.end.v), rms(dp), rms(trial.end.p)) && followed;
        report = convergence.report();
    }
    report.linearIterations = momentum.linearIterations();
    report.drive.template head<Dim>() = trial.drive;
    return accepted<Dim>(fluid, solid, trial, report);
}

}  // namespace

template <int Dim>
StepResult<Dim> fsiStep(const Step<Dim>& step, const Controls& controls) {
    Trial<Dim> trial = firstTrial<Dim>(step);
    try {
        return iterate<Dim>(step, controls, trial);
    } catch (const StepFailure& failure) {
        throw FailedStep<Dim>(failure, std::move(trial.end), step.mesh);
    }
}

#define PFEM_INSTANTIATE(D) template StepResult<D> fsiStep<D>(const Step<D>&, const Controls&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
