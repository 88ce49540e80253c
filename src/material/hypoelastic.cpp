#include "material/hypoelastic.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace pfem {

namespace {

template <int Dim>
double zzComponent(const Stress<Dim>& s) {
    return s[2];
}

/// Rotation by `fraction` of the angle 2 atan(|w|/2) around the axis of the skew tensor W.
template <int Dim>
Tensor<Dim> rotation(const Tensor<Dim>& W, double fraction) {
    if constexpr (Dim == 2) {
        return Eigen::Rotation2Dd(fraction * 2 * std::atan(W(1, 0) / 2)).toRotationMatrix();
    } else {
        const Vec<3> w(W(2, 1), W(0, 2), W(1, 0));
        const double length = w.norm();
        if (length == 0) return Tensor<3>::Identity();
        return Eigen::AngleAxisd(fraction * 2 * std::atan(length / 2), w / length).toRotationMatrix();
    }
}

}  // namespace

template <int Dim>
Stress<Dim> elasticStress(const IsotropicElasticity& elastic, const Tensor<Dim>& D) {
    const double mean = elastic.lambda() * D.trace();
    return packStress<Dim>(2 * elastic.mu() * D + mean * Tensor<Dim>::Identity(), mean);
}

template <int Dim>
Stress<Dim> rotatedMidpoint(const IsotropicElasticity& elastic, const Stress<Dim>& sigmaOld,
                            const Tensor<Dim>& increment) {
    const Tensor<Dim> D = 0.5 * (increment + increment.transpose());
    const Tensor<Dim> W = 0.5 * (increment - increment.transpose());
    const Tensor<Dim> R = rotation<Dim>(W, 1.0);
    const Tensor<Dim> half = rotation<Dim>(W, 0.5);
    const Stress<Dim> added = elasticStress<Dim>(elastic, D);
    const Tensor<Dim> sum =
        R * stressTensor<Dim>(sigmaOld) * R.transpose() + half * stressTensor<Dim>(added) * half.transpose();
    return packStress<Dim>(sum, zzComponent<Dim>(sigmaOld) + zzComponent<Dim>(added));
}

template <int Dim>
Tensor<Dim> halfRotation(const Tensor<Dim>& increment) {
    return rotation<Dim>(0.5 * (increment - increment.transpose()), 0.5);
}

template <int Dim>
Stress<Dim> paperUpdate(const IsotropicElasticity& elastic, const Stress<Dim>& sigmaOld, const Tensor<Dim>& gradV,
                        double dt) {
    const Tensor<Dim> De = 0.5 * dt * (gradV + gradV.transpose());
    return sigmaOld + elasticStress<Dim>(elastic, De);
}

#define PFEM_INSTANTIATE(D)                                                                                \
    template Stress<D> elasticStress<D>(const IsotropicElasticity&, const Tensor<D>&);                     \
    template Stress<D> rotatedMidpoint<D>(const IsotropicElasticity&, const Stress<D>&, const Tensor<D>&); \
    template Tensor<D> halfRotation<D>(const Tensor<D>&);                                                  \
    template Stress<D> paperUpdate<D>(const IsotropicElasticity&, const Stress<D>&, const Tensor<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
