#pragma once
// Walls and clamped edges that move as rigid bodies, prescribed in constant/boundaryConditions:
//
//     piston
//     {
//         type    slip;
//         motion  { displacement { type sine; frequency 1; scale (0.05 0 0); } }
//     }

#include <memory>
#include <optional>

#include "base/types.hpp"
#include "conditions/absorption.hpp"
#include "dictionary/function1.hpp"

namespace pfem {

/// A rigid displacement over a step, and the velocity at its end.
template <int Dim>
struct RigidStep {
    Tensor<Dim> rotation = Tensor<Dim>::Identity();  // over the step
    Vec<Dim> from = Vec<Dim>::Zero();                // centre before [m]
    Vec<Dim> to = Vec<Dim>::Zero();                  // and after
    Vec<Dim> velocity = Vec<Dim>::Zero();            // of the centre at the end [m/s]
    Tensor<Dim> spin = Tensor<Dim>::Zero();          // v = velocity + spin (x - to) [1/s]

    /// Where a point of the body comes to.
    Vec<Dim> carried(const Vec<Dim>& x) const { return to + rotation * (x - from); }
    /// Velocity of the body's point that is at x after the step.
    Vec<Dim> velocityAt(const Vec<Dim>& x) const { return velocity + spin * (x - to); }
};

/// Translation, and rotation about a point that translates.
class WallMotion {
public:
    /// Entries: displacement or velocity; angle or omega, origin, axis; absorb. UserError for none or both of a pair.
    /// `plane`: also for a z component, or another axis than z.
    explicit WallMotion(const Dictionary& dict, bool plane = false);

    /// The motion from time t0 to t1 [s], without what it gives way.
    template <int Dim>
    RigidStep<Dim> step(double t0, double t1) const;

    /// How it gives way to waves; nothing: it does not.
    const std::optional<Absorption>& absorption() const { return absorption_; }
    /// What is prescribed at a time t [s]: way since time 0, and velocity.
    Eigen::Vector3d way(double t) const { return displacement(0, t); }
    Eigen::Vector3d velocity(double t) const;

private:
    Eigen::Vector3d displacement(double t0, double t1) const;  // between two times
    double angle(double t0, double t1) const;

    Function1Ptr<Eigen::Vector3d> displacement_, velocity_;  // one of them, or none
    Function1Ptr<double> angle_, omega_;                     // [rad], [rad/s]: one of them, or none
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ();
    std::optional<Absorption> absorption_;
};

}  // namespace pfem
