#pragma once
// St. Venant-Kirchhoff solid: W = lambda/2 (tr E)^2 + mu E:E, E = (F^T F - I)/2. For large turns and small strains; in
// strong compression it gives way.

#include "material/hyperelasticLaw.hpp"

namespace pfem {

class StVenantKirchhoff : public HyperelasticLaw<StVenantKirchhoff> {
public:
    IsotropicElasticity elastic;

    template <class Visitor>
    void entries(Visitor& v) {
        elastic.entries(v);
    }
    IsotropicElasticity elasticity() const override { return elastic; }

    // W is no sum of a shear and a volumetric part: U is one with the bulk modulus of small strain, W_s the rest
    Tensor<3> shear(const Tensor<3>& F) const {
        const Tensor<3> I = Tensor<3>::Identity(), E = 0.5 * (F.transpose() * F - I);
        const Tensor<3> S = elastic.lambda() * E.trace() * I + 2 * elastic.mu() * E;
        const double J = F.determinant();
        return F * S * F.transpose() / J + volumePressure(J) * I;
    }
    double energy(const Tensor<3>& F) const {
        const Tensor<3> E = 0.5 * (F.transpose() * F - Tensor<3>::Identity());
        return 0.5 * elastic.lambda() * E.trace() * E.trace() + elastic.mu() * E.squaredNorm() -
               volumeEnergy(F.determinant());
    }
    double volumePressure(double J) const override {
        if (!(J > 0)) throw StepFailure("solid without volume: ratio of volumes <= 0");
        return -0.5 * elastic.kappa() * (J - 1 / J);
    }
    double volumeEnergy(double J) const override { return 0.25 * elastic.kappa() * (J * J - 1 - 2 * std::log(J)); }
};

}  // namespace pfem
