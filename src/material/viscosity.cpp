#include "material/viscosity.hpp"

#include <cmath>

namespace pfem {

template <int Dim>
double shearRate(const Tensor<Dim>& L) {
    const Tensor<Dim> d = 0.5 * (L + L.transpose());
    return std::sqrt(std::max(2 * (d.squaredNorm() - d.trace() * d.trace() / 3), 0.0));
}

template <int Dim>
Tensor<Dim> viscousStress(double mu, const Tensor<Dim>& L) {
    return mu * (L + L.transpose()) - (2 * mu / 3) * L.trace() * Tensor<Dim>::Identity();
}

template double shearRate<2>(const Tensor<2>&);
template double shearRate<3>(const Tensor<3>&);
template Tensor<2> viscousStress<2>(double, const Tensor<2>&);
template Tensor<3> viscousStress<3>(double, const Tensor<3>&);

}  // namespace pfem
