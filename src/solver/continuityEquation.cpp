#include "solver/continuityEquation.hpp"

#include "continuity/viscousPressure.hpp"

namespace pfem {

namespace {

/// Factor of mu div v in the change of pressure. A patch at the free surface, whose sides give way, resists its
/// swelling by mu/3 only (plane strain): more would overshoot.
template <int Dim>
std::vector<double> viscousPressureScale(double scale, const Topology<Dim>& topology) {
    std::vector<double> result(topology.nNodes(), scale);
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.freeSurface[i]) result[i] *= 1.0 / 3;
    return result;
}

}  // namespace

template <int Dim>
ContinuitySystem<Dim> ContinuityEquation<Dim>::makeSystem(const Points<Dim>& x) const {
    ContinuityControls controls = controls_.continuity;
    if (momentum_.isViscous()) controls.freeSurfaceScale *= 2;  // what mu div v adds to dp is not in the matrix
    return {step_, controls, fluid_, stabilisation_, x, momentum_.solidBlock()};
}

template <int Dim>
ContinuityEquation<Dim>::ContinuityEquation(const Step<Dim>& step, const Controls& controls,
                                            const FluidPhase<Dim>& fluid, const MomentumEquation<Dim>& momentum)
    : step_(step),
      controls_(controls),
      fluid_(fluid),
      momentum_(momentum),
      stabilisation_{stabilisation<Dim>(step.problem, fluid.cells, fluid.domains, fluid.mu, step.old.v, step.dt()),
                     projectedCells<Dim>(controls.continuity, step.problem, fluid.cells, step.topology, step.old)},
      system_(makeSystem(step.old.x)),
      viscousScale_(viscousPressureScale<Dim>(controls.continuity.viscousScale, step.topology)),
      acceleration_(controls.convergence.accelerationDepth) {}

template <int Dim>
std::vector<double> ContinuityEquation<Dim>::residual(const Trial<Dim>& trial) const {
    return continuityResidual<Dim>(step_, controls_.continuity, fluid_, stabilisation_, trial);
}

template <int Dim>
std::vector<double> ContinuityEquation<Dim>::solve(const std::vector<double>& residual, const Trial<Dim>& trial) {
    if (iterations_ > 0 && iterations_ % controls_.convergence.refactorEvery == 0) {
        restart();
        system_ = makeSystem(trial.middle.x);
    }
    ++iterations_;
    auto dp = system_.solve(residual);
    if (momentum_.isViscous()) addViscousPressure<Dim>(fluid_.domains, fluid_.tangent(), viscousScale_, residual, dp);
    step_.follow(dp);
    return dp;
}

#define PFEM_INSTANTIATE(D) template class ContinuityEquation<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
