#pragma once
// A body that moves as a whole: its velocity and turning are unknowns in place of its nodes' velocities.

#include <optional>
#include <vector>

#include "conditions/wallMotion.hpp"
#include "material/restraint.hpp"

namespace pfem {

/// (V, omega): velocity of the body's reference point and angular velocity, 2D: (V_x, V_y, omega).
template <int Dim>
inline constexpr int nTwist = Dim*(Dim + 1) / 2;
template <int Dim>
using Twist = Eigen::Matrix<double, nTwist<Dim>, 1>;
template <int Dim>
using TwistMatrix = Eigen::Matrix<double, nTwist<Dim>, nTwist<Dim>>;

/// [1, - r x]: the velocity at the lever r from the reference point is this times the twist; a force f there has the
/// force and moment this^T f.
template <int Dim>
Eigen::Matrix<double, Dim, nTwist<Dim>> leverRows(const Vec<Dim>& r) {
    Eigen::Matrix<double, Dim, nTwist<Dim>> rows;
    rows.template leftCols<Dim>().setIdentity();
    if constexpr (Dim == 2)
        rows.col(2) = Vec<2>(-r[1], r[0]);
    else
        rows.template rightCols<3>() << 0, r[2], -r[1], -r[2], 0, r[0], r[1], -r[0], 0;
    return rows;
}

/// Where a body is: place of its reference point, and how it has turned since the reference state.
template <int Dim>
struct Pose {
    Vec<Dim> at = Vec<Dim>::Zero();
    Tensor<Dim> turn = Tensor<Dim>::Identity();

    Vec<Dim> lever(const Vec<Dim>& arm) const { return turn * arm; }
    Vec<Dim> place(const Vec<Dim>& arm) const { return at + turn * arm; }
};

/// All arms are from the reference point to the body's points in the reference state.
template <int Dim>
struct RigidBody {
    int material = -1;
    std::vector<int> nodes;
    Points<Dim> arm;                                    // of the nodes
    double mass = 0;                                    // [kg/m (2D), kg]
    Vec<Dim> centre = Vec<Dim>::Zero();                 // arm of the centre of mass
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about it, in the reference state; 2D: (2, 2) alone
    Pose<Dim> pose;                                     // at t^n
    Twist<Dim> twist = Twist<Dim>::Zero();              // at t^n
    Eigen::Matrix<double, nTwist<Dim>, Eigen::Dynamic, 0, nTwist<Dim>, nTwist<Dim>> free;  // its motions, by columns
    std::optional<RigidStep<Dim>> follows;                                                 // a clamp and its motion
    const std::vector<RigidRestraint>* restraints = nullptr;

    int nFree() const { return static_cast<int>(free.cols()); }

    /// x = x^n + dt/2 (V^n + V), turned by the mean angular velocity; prescribed motion: by that.
    Pose<Dim> moved(const Twist<Dim>& end, double dt) const;

    /// At the end of the step, `at` being the pose there: of a body that follows a motion, that of the motion.
    Twist<Dim> twistAt(const Pose<Dim>& at, const Twist<Dim>& end) const;

    /// Generalised mass [M, - M rho x; M rho x, I_c - M rho x rho x] about the reference point, rho = c - o.
    TwistMatrix<Dim> massMatrix(const Pose<Dim>& at) const;
};

/// The twist that is nearest to velocities u at levers r, in the mean square.
template <int Dim>
Twist<Dim> nearestTwist(const Points<Dim>& r, const Points<Dim>& u);

/// Forces at the levers r whose sum and moment are W, least in the mean square.
template <int Dim>
Points<Dim> spreadForce(const Points<Dim>& r, const Twist<Dim>& W);

}  // namespace pfem
