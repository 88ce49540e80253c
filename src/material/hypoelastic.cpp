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
Tensor<Dim> stressTensor(const Stress<Dim>& s) {
    Tensor<Dim> t;
    if constexpr (Dim == 2)
        t << s[0], s[3], s[3], s[1];
    else
        t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    return t;
}

template <int Dim>
Stress<Dim> packStress(const Tensor<Dim>& t, double zz) {
    Stress<Dim> s;
    if constexpr (Dim == 2)
        s << t(0, 0), t(1, 1), zz, t(0, 1);
    else
        s << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2);
    return s;
}

template <int Dim>
double pressure(const Stress<Dim>& sigma) {
    return -(sigma[0] + sigma[1] + sigma[2]) / 3;
}

template <int Dim>
Stress<Dim> withPressure(const Stress<Dim>& s, double p) {
    Stress<Dim> sigma = s;
    for (int c = 0; c < 3; ++c) sigma[c] -= p;
    return sigma;
}

template <int Dim>
Stress<Dim> deviator(const Stress<Dim>& sigma) {
    return withPressure<Dim>(sigma, -pressure<Dim>(sigma));
}

template <int Dim>
Stress<Dim> elasticStress(const Hypoelastic& material, const Tensor<Dim>& D) {
    const double mean = material.lambda() * D.trace();
    return packStress<Dim>(2 * material.mu() * D + mean * Tensor<Dim>::Identity(), mean);
}

template <int Dim>
Stress<Dim> rotatedMidpoint(const Hypoelastic& material, const Stress<Dim>& sigmaOld, const Tensor<Dim>& increment) {
    const Tensor<Dim> D = 0.5 * (increment + increment.transpose());
    const Tensor<Dim> W = 0.5 * (increment - increment.transpose());
    const Tensor<Dim> R = rotation<Dim>(W, 1.0);
    const Tensor<Dim> half = rotation<Dim>(W, 0.5);
    const Stress<Dim> added = elasticStress<Dim>(material, D);
    const Tensor<Dim> sum =
        R * stressTensor<Dim>(sigmaOld) * R.transpose() + half * stressTensor<Dim>(added) * half.transpose();
    return packStress<Dim>(sum, zzComponent<Dim>(sigmaOld) + zzComponent<Dim>(added));
}

template <int Dim>
Tensor<Dim> halfRotation(const Tensor<Dim>& increment) {
    return rotation<Dim>(0.5 * (increment - increment.transpose()), 0.5);
}

template <int Dim>
Stress<Dim> paperUpdate(const Hypoelastic& material, const Stress<Dim>& sigmaOld, const Tensor<Dim>& gradV, double dt) {
    const Tensor<Dim> De = 0.5 * dt * (gradV + gradV.transpose());
    return sigmaOld + elasticStress<Dim>(material, De);
}

#define PFEM_INSTANTIATE(D)                                                                        \
    template Tensor<D> stressTensor<D>(const Stress<D>&);                                          \
    template double pressure<D>(const Stress<D>&);                                                 \
    template Stress<D> deviator<D>(const Stress<D>&);                                              \
    template Stress<D> withPressure<D>(const Stress<D>&, double);                                  \
    template Stress<D> packStress<D>(const Tensor<D>&, double);                                    \
    template Stress<D> elasticStress<D>(const Hypoelastic&, const Tensor<D>&);                     \
    template Stress<D> rotatedMidpoint<D>(const Hypoelastic&, const Stress<D>&, const Tensor<D>&); \
    template Tensor<D> halfRotation<D>(const Tensor<D>&);                                          \
    template Stress<D> paperUpdate<D>(const Hypoelastic&, const Stress<D>&, const Tensor<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
