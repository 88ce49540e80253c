#pragma once
// ONE linear system for the velocities of fluid and solid together: (M + K) dv = -R_m (40)-(43).

#include "momentum/fluidPhase.hpp"
#include "momentum/solidMatrix.hpp"
#include "momentum/step.hpp"

namespace pfem {

/// Conjugate gradients on the whole system. The fluid's operator is applied (G, then C, then G^T), never
/// assembled; the solid's matrix is factorised once per step. Preconditioner: the solid block's factor and the
/// fluid's diagonal.
template <int Dim>
class MomentumSystem {
public:
    /// The references must outlive the system. `fluid`: its current geometry and viscosity are used by solve.
    MomentumSystem(const Step<Dim>& step, const MomentumControls& controls, const FluidPhase<Dim>& fluid,
                   const Points<Dim>& inertia, SolidBlock<Dim> solid);

    /// matrixInertia of the fluid's nodes in the current configuration (the solid's factor stays).
    void setInertia(const Points<Dim>& inertia);

    /// Directions of the unknowns of rigid bodies, whose levers are those of the iterate (the solid's factor stays).
    SolidDofs<Dim>& solidDofs() { return solid_.dofs; }

    /// Forces on nodes as a right-hand side of the solids' unknowns; the change of these that it makes; and that change
    /// as velocities of the nodes.
    Eigen::VectorXd onSolids(const std::vector<std::pair<int, Vec<Dim>>>& forces) const;
    Eigen::VectorXd solveSolids(const Eigen::VectorXd& f) const { return f.size() > 0 ? solid_.factor->solve(f) : f; }
    void addOfSolids(const Eigen::VectorXd& change, Points<Dim>& dv) const { scatter(change, dv); }

    /// The fluid's viscosity has changed.
    void updateViscosity();

    /// dv of all nodes for the right-hand side -R; zero where a velocity is prescribed and on isolated nodes.
    Points<Dim> solve(const Points<Dim>& residual);

    /// Ratio of viscous forces to inertia, 2 mu dt/(rho h^2), that more than a few light nodes exceed; to a factor of
    /// two.
    double viscousNumber() const { return viscousNumber_; }

    /// Is the viscosity in the matrix, not only in the residual?
    bool isViscous() const { return viscous_; }

    int linearIterations() const { return iterations_; }  // of the last solve
    const SolidBlock<Dim>& solid() const { return solid_; }

private:
    bool isConsistent() const { return controls_.fluidMass() == FluidMass::consistent; }
    Points<Dim> apply(const Points<Dim>& u) const;
    void addOfFluid(Points<Dim> u, Points<Dim>& force) const;
    Points<Dim> precondition(const Points<Dim>& r) const;
    Points<Dim> restricted(Points<Dim> r) const;
    Points<Dim> ofImages(Points<Dim> dv) const;
    Eigen::VectorXd gather(const Points<Dim>& r) const;
    Eigen::VectorXd perBody(Eigen::VectorXd f) const;
    void spreadOverBodies(Points<Dim>& force) const;
    void scatter(const Eigen::VectorXd& u, Points<Dim>& r) const;

    MomentumControls controls_;
    const Step<Dim> step_;
    const NodeConstraints<Dim>& constraints_;
    const FluidPhase<Dim>& fluid_;
    SolidBlock<Dim> solid_;
    double massFactor_;                    // of the mass in the matrix [1/s]
    std::vector<Eigen::MatrixXd> ofBody_;  // (B^T B)^-1 of rigid bodies whose nodes' velocities are B times their own
    std::vector<unsigned char> moving_;    // fluid nodes with unknowns, solids left out
    Points<Dim> inertia_;                  // of moving fluid nodes; of a sliding one the same in all directions
    std::vector<double> diagonal_;         // its least component, 0 elsewhere
    std::vector<double> viscousDiagonal_;  // about that of the viscous matrix, where it is applied
    PerPoint<double> bulk_;                // theta times bulkRule's value [Pa s], empty without
    double viscousNumber_ = 0;
    bool viscous_ = false;
    int iterations_ = 0;
};

}  // namespace pfem
