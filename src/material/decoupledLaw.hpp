#pragma once
// Base of nearly incompressible hyperelastic laws: W = W_iso(b') + U(J), b' = J^(-2/3) F F^T,
// U = kappa/4 (J^2 - 1 - 2 ln J).

#include <Eigen/LU>

#include "material/hyperelasticLaw.hpp"

namespace pfem {

/// b' and its invariants: I1 = tr b', I2 = (I1^2 - tr b'^2)/2.
struct Isochoric {
    explicit Isochoric(const Tensor<3>& F)
        : J(F.determinant()),
          b(std::pow(J, -2.0 / 3) * F * F.transpose()),
          I1(b.trace()),
          I2(0.5 * (I1 * I1 - b.squaredNorm())) {}

    double J;
    Tensor<3> b;
    double I1, I2;

    /// Cauchy stress of an energy of the invariants from its derivatives W1 = dW/dI1 and W2 = dW/dI2.
    Tensor<3> stress(double W1, double W2) const {
        const Tensor<3> t = 2 / J * ((W1 + I1 * W2) * b - W2 * b * b);
        return t - t.trace() / 3 * Tensor<3>::Identity();
    }
};

/// Law: shearModulus() at small strain, shear(F) and energy(F) of W_iso. The bulk modulus is that of Poisson's ratio.
template <class Law>
class DecoupledLaw : public HyperelasticLaw<Law> {
public:
    double nu = 0;

    template <class Visitor>
    void volumeEntries(Visitor& v) {
        v.required("nu", nu, "-", "Poisson's ratio at small strain, from which the bulk modulus follows",
                   poissonsRatio);
    }
    IsotropicElasticity elasticity() const override { return {2 * this->law().shearModulus() * (1 + nu), nu}; }
    double volumePressure(double J) const override {
        if (!(J > 0)) throw StepFailure("solid without volume: ratio of volumes <= 0");
        return -0.5 * volumeModulus() * (J - 1 / J);
    }
    double volumeEnergy(double J) const override { return 0.25 * volumeModulus() * (J * J - 1 - 2 * std::log(J)); }
    double volumeModulus() const override { return this->elasticity().kappa(); }
};

}  // namespace pfem
