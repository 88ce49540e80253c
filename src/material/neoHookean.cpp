#include "material/neoHookean.hpp"

#include <Eigen/LU>
#include <cmath>

#include "base/error.hpp"

namespace pfem {

template <int Dim>
Stress<Dim> neoHookeanShear(const IsotropicElasticity& elastic, const Tensor<Dim>& F) {
    const double J = F.determinant();
    if (!(J > 0)) throw StepFailure("solid turned inside out: deformation gradient with det F <= 0");
    const Tensor<Dim> b = F * F.transpose() - Tensor<Dim>::Identity();
    return packStress<Dim>(elastic.mu() / J * b, 0);
}

double neoHookeanPressure(const IsotropicElasticity& elastic, double J) {
    if (!(J > 0)) throw StepFailure("solid without volume: ratio of volumes <= 0");
    return -elastic.lambda() * std::log(J) / J;
}

template <int Dim>
Stress<Dim> neoHookeanStress(const IsotropicElasticity& elastic, const Tensor<Dim>& F) {
    return withPressure<Dim>(neoHookeanShear<Dim>(elastic, F), neoHookeanPressure(elastic, F.determinant()));
}

template <int Dim>
double neoHookeanShearEnergy(const IsotropicElasticity& elastic, const Tensor<Dim>& F) {
    return 0.5 * elastic.mu() * (F.squaredNorm() - Dim) - elastic.mu() * std::log(F.determinant());
}

double neoHookeanVolumeEnergy(const IsotropicElasticity& elastic, double J) {
    const double logJ = std::log(J);
    return 0.5 * elastic.lambda() * logJ * logJ;
}

template <int Dim>
double neoHookeanEnergy(const IsotropicElasticity& elastic, const Tensor<Dim>& F) {
    return neoHookeanShearEnergy<Dim>(elastic, F) + neoHookeanVolumeEnergy(elastic, F.determinant());
}

template <int Dim>
Tensor<Dim> firstPiola(const Stress<Dim>& sigma, const Tensor<Dim>& F) {
    return F.determinant() * stressTensor<Dim>(sigma) * F.inverse().transpose();
}

#define PFEM_INSTANTIATE(D)                                                                 \
    template Stress<D> neoHookeanShear<D>(const IsotropicElasticity&, const Tensor<D>&);    \
    template double neoHookeanShearEnergy<D>(const IsotropicElasticity&, const Tensor<D>&); \
    template Stress<D> neoHookeanStress<D>(const IsotropicElasticity&, const Tensor<D>&);   \
    template double neoHookeanEnergy<D>(const IsotropicElasticity&, const Tensor<D>&);      \
    template Tensor<D> firstPiola<D>(const Stress<D>&, const Tensor<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
