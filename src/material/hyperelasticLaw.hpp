#pragma once
// Base of laws with a stored energy W(F) = W_s(F) + U(J), J = det F > 0:
//
//     class MyLaw : public HyperelasticLaw<MyLaw> {
//     public:
//         ... entries, elasticity() ...
//         Tensor<3> shear(const Tensor<3>& F) const;              // of W_s: Cauchy stress [Pa]
//         double energy(const Tensor<3>& F) const;                // W_s [J/m3]
//         double volumePressure(double J) const override;         // - dU/dJ
//         double volumeEnergy(double J) const override;           // U
//         double volumeModulus() const override;                  // d^2U/dJ^2 at J = 1; without: kappa
//     };
//
// A law that remembers has shear(F, step) and energy(F, history).

#include <Eigen/LU>
#include <cmath>

#include "base/error.hpp"
#include "material/rateLaw.hpp"

namespace pfem {

/// F in space (2D: F_zz = 1). Throws StepFailure unless det F > 0.
template <int Dim>
Tensor<3> deformationInSpace(const Tensor<Dim>& F) {
    if (!(F.determinant() > 0)) throw StepFailure("solid turned inside out: deformation gradient with det F <= 0");
    return inSpace<Dim>(F, 1);
}

template <class Law>
class HyperelasticLaw : public SolidLawOf<Law> {
public:
    Kinematics kinematics() const override { return Kinematics::reference; }

    template <int Dim>
    void stressOf(const SolidPoints<Dim>& points) const {
        const int width = points.size() == 0 ? 0 : static_cast<int>(points.history.size()) / points.size();
        for (int p = 0; p < points.size(); ++p) {
            const Tensor<3> F = deformationInSpace<Dim>(points.gradient[p]);
            if constexpr (requires(const Law& law) { law.shear(F); })
                points.sigma[p] = stored<Dim>(this->law().shear(F));
            else
                points.sigma[p] = stored<Dim>(this->law().shear(
                    F, RateStep{ofPoint(points.before, width, p), ofPoint(points.history, width, p), points.dt}));
        }
    }
    double shearEnergy(const Tensor<2>& F, std::span<const double> history) const final {
        return energyInSpace(deformationInSpace<2>(F), history);
    }
    double shearEnergy(const Tensor<3>& F, std::span<const double> history) const final {
        return energyInSpace(deformationInSpace<3>(F), history);
    }

private:
    double energyInSpace(const Tensor<3>& F, std::span<const double> history) const {
        if constexpr (requires(const Law& law) { law.energy(F); })
            return this->law().energy(F);
        else
            return this->law().energy(F, history);
    }
};

}  // namespace pfem
