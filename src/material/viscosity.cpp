#include "material/viscosity.hpp"

#include <cmath>

namespace pfem {

template <int Dim>
double shearRate(const Tensor<Dim>& L) {
    const Tensor<Dim> d = 0.5 * (L + L.transpose());
    return std::sqrt(std::max(2 * (d.squaredNorm() - d.trace() * d.trace() / 3), 0.0));
}

double viscosity(const ViscousFluid& fluid, double shearRate) {
    if (fluid.isNewtonian()) return fluid.mu;
    const double m = fluid.regularisation;
    const double yielding = m * shearRate < 1e-8 ? m : -std::expm1(-m * shearRate) / shearRate;
    const double flowing = fluid.exponent == 1 ? 1 : std::pow(std::hypot(shearRate, 1 / m), fluid.exponent - 1);
    return fluid.yieldStress * yielding + fluid.mu * flowing;
}

double viscositySlope(const ViscousFluid& fluid, double shearRate) {
    if (fluid.isNewtonian()) return 0;
    const double m = fluid.regularisation, mg = m * shearRate;
    const double yielding =
        mg < 1e-4 ? m * m * (mg / 3 - 0.5) : (mg * std::exp(-mg) + std::expm1(-mg)) / (shearRate * shearRate);
    const double n = fluid.exponent;
    const double flowing = n == 1 ? 0 : (n - 1) * shearRate * std::pow(std::hypot(shearRate, 1 / m), n - 3);
    return fluid.yieldStress * yielding + fluid.mu * flowing;
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
