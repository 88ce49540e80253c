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
ContinuitySystem<Dim> ContinuityEquation<Dim>::makeSystem(const FluidPhase<Dim>& fluid, const Points<Dim>& x) const {
    ContinuityControls controls = controls_.continuity;
    if (momentum_.isViscous()) controls.freeSurfaceScale *= 2;  // what mu div v adds to dp is not in the matrix
    return {step_, controls, fluid, stabilisation_, x, momentum_.solidBlock()};
}

template <int Dim>
ContinuityEquation<Dim>::ContinuityEquation(const Step<Dim>& step, const Controls& controls,
                                            const FluidPhase<Dim>& fluid, const MomentumEquation<Dim>& momentum)
    : step_(step),
      controls_(controls),
      fluid_(fluid),
      momentum_(momentum),
      ownRows_(!fluid.domains.share.isWhole()),
      stabilisation_{stabilisation<Dim>(step.problem, fluid.cells, fluid.domains, fluid.mu, step.old.v, step.dt()),
                     projectedCells<Dim>(controls.continuity, step.problem, fluid.cells, step.topology, step.old)},
      system_(makeSystem(fluid, step.old.x)),
      viscousScale_(viscousPressureScale<Dim>(controls.continuity.viscousScale, step.topology)),
      acceleration_(controls.convergence.accelerationDepth) {}

template <int Dim>
std::vector<double> ContinuityEquation<Dim>::residual(const Trial<Dim>& trial) const {
    auto R = continuityResidual<Dim>(step_, controls_.continuity, fluid_, stabilisation_, trial);
    fluid_.domains.share.gather(R);
    return R;
}

template <int Dim>
std::vector<double> ContinuityEquation<Dim>::solve(const std::vector<double>& residual, const Trial<Dim>& trial) {
    if (iterations_ > 0 && iterations_ % controls_.convergence.refactorEvery == 0) {
        restart();
        const auto& x = trial.middle.x;
        const bool asItIs = ownRows_ || fluid_.domains.share.isWhole();
        system_ = asItIs ? makeSystem(fluid_, x) : makeSystem(fluid_.whole(x), x);
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
