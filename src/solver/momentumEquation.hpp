#pragma once
// The momentum equation of a step: its residual (23)-(24), and the velocities that answer it (40)-(43).

#include <limits>

#include "momentum/contactForces.hpp"
#include "momentum/momentumSystem.hpp"
#include "momentum/residual.hpp"
#include "solver/controls.hpp"
#include "solver/newtonDamping.hpp"

namespace pfem {

/// R_J = m_J (a_J - g) + f_J, all forces in the middle of the step; those of solids are the mean of both ends'.
template <int Dim>
class MomentumEquation {
public:
    /// With the phases at x^n, where the matrix is made. The references must outlive the equation.
    MomentumEquation(const Step<Dim>& step, const Controls& controls, const FluidPhase<Dim>& fluid,
                     const SolidPhase<Dim>& solid);

    /// R_m of the iterate, over gamma [N/m (2D), N]. A viscous force that can hardly change any more stays as it is:
    /// `change`: |dv|/|v| of the last iteration, whatever for the first.
    Points<Dim> residual(const Trial<Dim>& trial, double change);

    /// dv for the right-hand side -R_m of the last residual, which is that of the iterate.
    Points<Dim> solve(const Points<Dim>& residual, const Trial<Dim>& trial);

    /// dv that answers an acceleration of the fluid, to the first order.
    Points<Dim> answer(const Vec<Dim>& acceleration);

    /// The part of dv to take: less than all where a viscosity that depends on the flow would make it overshoot.
    double part(const Points<Dim>& dv) { return fluid_.newtonian ? 1 : damping_.next(dv); }

    /// Is viscosity in the matrix?
    bool isViscous() const { return system_.isViscous(); }

    /// Conjugate gradients of all iterations together.
    int linearIterations() const { return linearIterations_; }

    const MomentumSystem<Dim>& system() const { return system_; }
    const SolidBlock<Dim>& solidBlock() const { return system_.solid(); }

private:
    Points<Dim> inertia() const { return matrixInertia<Dim>(mass_, stiffness_, step_.midpoint); }
    MomentumSystem<Dim> makeSystem(const Controls& controls) const;
    std::vector<double> wholeMass() const;  // of all nodes, also where a share of them is worked off

    const Step<Dim>& step_;
    const FluidPhase<Dim>& fluid_;
    const SolidPhase<Dim>& solid_;
    double waveDamping_;  // of zigzagForce
    FluidMass fluidMass_;
    double tolerance_;           // of |dv|/|v|
    Points<Dim> solidForceOld_;  // at t^n
    Points<Dim> stiffness_;      // of the surface
    std::vector<double> mass_;
    MomentumSystem<Dim> system_;
    ContactForces<Dim> contact_;
    NewtonDamping<Dim> damping_;
    Points<Dim> viscous_;
    int linearIterations_ = 0;
};

}  // namespace pfem
