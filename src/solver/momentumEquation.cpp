#include "solver/momentumEquation.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "momentum/consistentMass.hpp"
#include "momentum/riderMatrix.hpp"
#include "momentum/rigidInertia.hpp"
#include "momentum/surfaceStiffness.hpp"
#include "solver/scales.hpp"

namespace pfem {

template <int Dim>
std::vector<double> MomentumEquation<Dim>::wholeMass() const {
    auto mass = nodalMass<Dim>(fluid_, solid_);
    fluid_.domains.share.gather(mass);
    return mass;
}

template <int Dim>
MomentumSystem<Dim> MomentumEquation<Dim>::makeSystem(const Controls& controls) const {
    const auto diagonal = inertia();
    SolidBlock<Dim> block;
    block.dofs = solidDofs<Dim>(step_.topology.solid, step_.constraints);
    block.matrix = solidMatrix<Dim>(solid_.solids, solid_.domains, block.dofs, diagonal, step_.old.h, step_.midpoint);
    addRigidMatrix<Dim>(step_, block);
    addRiders<Dim>(step_.constraints.riders, diagonal, block);
    return MomentumSystem<Dim>(step_, controls.momentum, fluid_, diagonal, std::move(block));
}

template <int Dim>
MomentumEquation<Dim>::MomentumEquation(const Step<Dim>& step, const Controls& controls, const FluidPhase<Dim>& fluid,
                                        const SolidPhase<Dim>& solid)
    : step_(step),
      fluid_(fluid),
      solid_(solid),
      waveDamping_(controls.momentum.waveDamping),
      fluidMass_(controls.momentum.fluidMass()),
      tolerance_(controls.convergence.tolU),
      solidForceOld_(step.old.size(), Vec<Dim>::Zero()),
      stiffness_(surfaceStiffness<Dim>(step.problem, step.mesh.fluid, step.topology, step.old.x, step.midpoint)),
      mass_(wholeMass()),
      system_(makeSystem(controls)),
      contact_(step.contacts ? *step.contacts : std::vector<ContactPair<Dim>>(), step.dt(),
               step.problem.contact.friction) {
    addInternalForce<Dim>(solid.domains, solid.elementStress, solidForceOld_);
}

template <int Dim>
Points<Dim> MomentumEquation<Dim>::residual(const Trial<Dim>& trial, double change) {
    const int n = trial.end.size();
    const double gamma = step_.gamma();
    if (!fluid_.newtonian) system_.updateViscosity();
    mass_ = wholeMass();
    const double damped =
        2 * waveDamping_ * step_.dt() * std::sqrt(step_.problem.gravity.norm() / meanSize<Dim>(step_.old));
    if (viscous_.empty() || std::max(system_.viscousNumber(), damped) * change > 0.1 * tolerance_)
        viscous_ = viscousForces<Dim>(fluid_, waveDamping_, trial.middle);
    auto external = externalForce<Dim>(step_.mesh, step_.topology, fluid_, trial.middle);
    parallelFor(n, [&](int i) { external[i] -= viscous_[i] + (1 - gamma) * solidForceOld_[i]; });
    if (!trial.drive.isZero(0))
        parallelFor(n, [&](int i) { external[i] += (mass_[i] - solid_.mass[i]) * trial.drive; });
    auto R = momentumResidual<Dim>(mass_, trial.middle, fluid_, solid_, external, gamma);
    if (fluidMass_ == FluidMass::consistent) addMassDifference<Dim>(fluid_, 1, trial.middle.a, R);
    fluid_.domains.share.gather(R);
    addRigidInertia<Dim>(step_, trial, R);
    setLevers<Dim>(step_, trial, system_.solidDofs());
    parallelFor(n, [&](int i) { R[i] /= gamma; });
    return R;
}

template <int Dim>
Points<Dim> MomentumEquation<Dim>::solve(const Points<Dim>& residual, const Trial<Dim>& trial) {
    system_.setInertia(inertia());
    auto dv = system_.solve(residual);
    contact_.add(system_, trial.end, dv);
    linearIterations_ += system_.linearIterations();
    return dv;
}

template <int Dim>
Points<Dim> MomentumEquation<Dim>::answer(const Vec<Dim>& acceleration) {
    Points<Dim> R(mass_.size());
    parallelFor(static_cast<int>(R.size()),
                [&](int i) { R[i] = -(mass_[i] - solid_.mass[i]) * acceleration / step_.gamma(); });
    auto dv = system_.solve(R);
    linearIterations_ += system_.linearIterations();
    return dv;
}

#define PFEM_INSTANTIATE(D) template class MomentumEquation<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
