#pragma once
// Compressible neo-Hookean solid, from the deformation gradient alone: W = mu/2 (tr b - 3) - mu ln J + lambda/2 (ln
// J)^2 with b = F F^T, J = det F. It has the elastic constants of the hypoelastic law and agrees with it at small
// strain. 2D is plane strain: F_zz = 1.

#include "material/solidLaw.hpp"
#include "material/stressTensor.hpp"

namespace pfem {

/// sigma = (mu (b - I) + lambda ln J I) / J. Throws StepFailure unless J > 0.
template <int Dim>
Stress<Dim> neoHookeanStress(const IsotropicElasticity& elastic, const Tensor<Dim>& F);

/// The two parts of sigma: mu (b - I) / J, and - p I with p = - lambda ln J / J. Where volumes are counted at the nodes
/// (velocityPressure) each has its own J. Both throw StepFailure unless J > 0.
template <int Dim>
Stress<Dim> neoHookeanShear(const IsotropicElasticity& elastic, const Tensor<Dim>& F);
double neoHookeanPressure(const IsotropicElasticity& elastic, double J);

/// The two parts of W: mu/2 (tr b - 3) - mu ln J, and lambda/2 (ln J)^2.
template <int Dim>
double neoHookeanShearEnergy(const IsotropicElasticity& elastic, const Tensor<Dim>& F);
double neoHookeanVolumeEnergy(const IsotropicElasticity& elastic, double J);

/// W per reference volume [J/m3]: dW/dF = P.
template <int Dim>
double neoHookeanEnergy(const IsotropicElasticity& elastic, const Tensor<Dim>& F);

/// First Piola stress P = J sigma F^{-T} (2D: in the plane): force per reference area.
template <int Dim>
Tensor<Dim> firstPiola(const Stress<Dim>& sigma, const Tensor<Dim>& F);

/// The law `neoHookean`.
class NeoHookean : public SolidLawOf<NeoHookean> {
public:
    IsotropicElasticity elastic;

    template <class Visitor>
    void entries(Visitor& v) {
        elastic.entries(v);
    }
    Kinematics kinematics() const override { return Kinematics::reference; }
    IsotropicElasticity elasticity() const override { return elastic; }

    template <int Dim>
    void stressOf(const SolidPoints<Dim>& points) const {
        for (int p = 0; p < points.size(); ++p) points.sigma[p] = neoHookeanShear<Dim>(elastic, points.gradient[p]);
    }
    double volumePressure(double J) const override { return neoHookeanPressure(elastic, J); }
    double volumeEnergy(double J) const override { return neoHookeanVolumeEnergy(elastic, J); }
    double volumeModulus() const override { return elastic.lambda(); }
    double shearEnergy(const Tensor<2>& F, std::span<const double>) const override {
        return neoHookeanShearEnergy<2>(elastic, F);
    }
    double shearEnergy(const Tensor<3>& F, std::span<const double>) const override {
        return neoHookeanShearEnergy<3>(elastic, F);
    }
};

}  // namespace pfem
