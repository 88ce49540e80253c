#include "conditions/rigidBody.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace pfem {

namespace {

/// Rotation by the vector phi [rad].
template <int Dim>
Tensor<Dim> rotation(const Twist<Dim>& turning, double time) {
    if constexpr (Dim == 2) {
        return Eigen::Rotation2Dd(time * turning[2]).toRotationMatrix();
    } else {
        const Vec<3> phi = time * turning.template tail<3>();
        const double angle = phi.norm();
        return angle > 0 ? Eigen::AngleAxisd(angle, phi / angle).toRotationMatrix() : Tensor<3>(Tensor<3>::Identity());
    }
}

/// sum of leverRows^T leverRows.
template <int Dim>
TwistMatrix<Dim> metric(const Points<Dim>& r) {
    TwistMatrix<Dim> G = TwistMatrix<Dim>::Zero();
    for (const auto& lever : r) {
        const auto rows = leverRows<Dim>(lever);
        G += rows.transpose() * rows;
    }
    return G;
}

}  // namespace

template <int Dim>
Pose<Dim> RigidBody<Dim>::moved(const Twist<Dim>& end, double dt) const {
    if (follows) return {follows->carried(pose.at), follows->rotation * pose.turn};
    return {pose.at + 0.5 * dt * (twist.template head<Dim>() + end.template head<Dim>()),
            rotation<Dim>(twist + end, 0.5 * dt) * pose.turn};
}

template <int Dim>
Twist<Dim> RigidBody<Dim>::twistAt(const Pose<Dim>& at, const Twist<Dim>& end) const {
    if (!follows) return end;
    Twist<Dim> result;
    result.template head<Dim>() = follows->velocityAt(at.at);
    const Tensor<Dim>& spin = follows->spin;
    if constexpr (Dim == 2)
        result[2] = spin(1, 0);
    else
        result.template tail<3>() << spin(2, 1), spin(0, 2), spin(1, 0);
    return result;
}

template <int Dim>
TwistMatrix<Dim> RigidBody<Dim>::massMatrix(const Pose<Dim>& at) const {
    const auto rows = leverRows<Dim>(at.lever(centre));
    TwistMatrix<Dim> M = mass * rows.transpose() * rows;
    if constexpr (Dim == 2)
        M(2, 2) += inertia(2, 2);
    else
        M.template bottomRightCorner<3, 3>() += at.turn * inertia * at.turn.transpose();
    return M;
}

template <int Dim>
Twist<Dim> nearestTwist(const Points<Dim>& r, const Points<Dim>& u) {
    Twist<Dim> sum = Twist<Dim>::Zero();
    for (std::size_t k = 0; k < r.size(); ++k) sum += leverRows<Dim>(r[k]).transpose() * u[k];
    return metric<Dim>(r).ldlt().solve(sum);
}

template <int Dim>
Points<Dim> spreadForce(const Points<Dim>& r, const Twist<Dim>& W) {
    const Twist<Dim> factor = metric<Dim>(r).ldlt().solve(W);
    Points<Dim> force;
    for (const auto& lever : r) force.push_back(leverRows<Dim>(lever) * factor);
    return force;
}

#define PFEM_INSTANTIATE(D)                                                \
    template struct RigidBody<D>;                                          \
    template Twist<D> nearestTwist<D>(const Points<D>&, const Points<D>&); \
    template Points<D> spreadForce<D>(const Points<D>&, const Twist<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
