#include "material/neoHookean.hpp"

#include <Eigen/LU>
#include <cmath>

#include "base/error.hpp"
#include "material/hypoelastic.hpp"

namespace pfem {

template <int Dim>
Stress<Dim> neoHookeanShear(const Hypoelastic& material, const Tensor<Dim>& F) {
    const double J = F.determinant();
    if (!(J > 0)) throw StepFailure("solid turned inside out: deformation gradient with det F <= 0");
    const Tensor<Dim> b = F * F.transpose() - Tensor<Dim>::Identity();
    return packStress<Dim>(material.mu() / J * b, 0);
}

double neoHookeanPressure(const Hypoelastic& material, double J) {
    if (!(J > 0)) throw StepFailure("solid without volume: ratio of volumes <= 0");
    return -material.lambda() * std::log(J) / J;
}

template <int Dim>
Stress<Dim> neoHookeanStress(const Hypoelastic& material, const Tensor<Dim>& F) {
    return withPressure<Dim>(neoHookeanShear<Dim>(material, F), neoHookeanPressure(material, F.determinant()));
}

template <int Dim>
double neoHookeanShearEnergy(const Hypoelastic& material, const Tensor<Dim>& F) {
    return 0.5 * material.mu() * (F.squaredNorm() - Dim) - material.mu() * std::log(F.determinant());
}

double neoHookeanVolumeEnergy(const Hypoelastic& material, double J) {
    const double logJ = std::log(J);
    return 0.5 * material.lambda() * logJ * logJ;
}

template <int Dim>
double neoHookeanEnergy(const Hypoelastic& material, const Tensor<Dim>& F) {
    return neoHookeanShearEnergy<Dim>(material, F) + neoHookeanVolumeEnergy(material, F.determinant());
}

template <int Dim>
Tensor<Dim> firstPiola(const Stress<Dim>& sigma, const Tensor<Dim>& F) {
    return F.determinant() * stressTensor<Dim>(sigma) * F.inverse().transpose();
}

#define PFEM_INSTANTIATE(D)                                                         \
    template Stress<D> neoHookeanShear<D>(const Hypoelastic&, const Tensor<D>&);    \
    template double neoHookeanShearEnergy<D>(const Hypoelastic&, const Tensor<D>&); \
    template Stress<D> neoHookeanStress<D>(const Hypoelastic&, const Tensor<D>&);   \
    template double neoHookeanEnergy<D>(const Hypoelastic&, const Tensor<D>&);      \
    template Tensor<D> firstPiola<D>(const Stress<D>&, const Tensor<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
