#pragma once
// Contact of solids inside the momentum equation: no approach, no pull, Coulomb's friction.

#include "momentum/momentumSystem.hpp"
#include "walls/solidContact.hpp"

namespace pfem {

/// Forces of the step between the pairs, L_c (normal, then along the face), that together with the velocities u_c of
/// the pairs at the end of the step obey
///     0 <= L_n  _|_  u_n - b >= 0,   b = - (gap + dt/2 u_n^n)/dt,        |L_t| <= mu L_n,  L_t against u_t where it
///     slips,
/// written with the gap of the iterate, b = u_n/2 - gap(x)/dt, so that bodies that turn obey it, too;
/// u = u_free + W L with W = J A^-1 J^T and the solids' matrix A. The bound b lets a pair come so near that the next
/// step can end at gap 0 with u_n = 0: what meets does so in two steps, without penetration, and stays together when
/// pressed. An impact takes the energy of the surface's lumped masses alone. Solved by projected Gauss-Seidel, pair by
/// pair; any number of pairs may hold one body.
template <int Dim>
class ContactForces {
public:
    ContactForces(std::vector<ContactPair<Dim>> pairs, double dt, double friction);

    bool any() const { return !pairs_.empty(); }

    /// Add to dv what the forces make of it. `end`: of the iterate before dv. Throws StepFailure where what is held
    /// on both sides is driven together.
    void add(const MomentumSystem<Dim>& system, const Nodes<Dim>& end, Points<Dim>& dv);

    /// Would a pair with the velocities v at the start of the step be closed before its middle, gap + dt/2 u_n < 0? The
    /// bound b > 0 would let it enter. What has come near at last instants only strikes like this: a corner round
    /// another, a body that a third one throws.
    bool strikes(const Points<Dim>& v) const;
    /// The inelastic impact that prevents it.
    void stop(const MomentumSystem<Dim>& system, Points<Dim>& v);

private:
    /// The least velocity u_n at the start of the step.
    double slowest(const ContactPair<Dim>& pair) const { return -2 * std::max(pair.gap, 0.0) / dt_; }
    void respond(const MomentumSystem<Dim>& system);
    void answer(std::vector<Vec<Dim>> u);
    void relax(std::vector<Vec<Dim>>& u);
    Eigen::VectorXd forces() const;  // L of all pairs
    void demandWay(const Nodes<Dim>& end) const;

    std::vector<ContactPair<Dim>> pairs_;
    double dt_, friction_;
    std::vector<double> bound_;  // b
    Eigen::MatrixXd answer_;     // A^-1 J^T, by columns
    Eigen::MatrixXd W_;
    std::vector<Vec<Dim>> force_;  // L
};

}  // namespace pfem
