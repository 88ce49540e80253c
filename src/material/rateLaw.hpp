#pragma once
// Base of laws whose stress follows from the stress before the step and the strain of the step:
//
//     class MyLaw : public RateLaw<MyLaw> {
//     public:
//         IsotropicElasticity elastic;
//         double strength = 0;
//         template <class Visitor>
//         void entries(Visitor& v) {
//             elastic.entries(v);
//             v.required("strength", strength, "Pa", "what it stands", positive);
//         }
//         IsotropicElasticity elasticity() const override { return elastic; }
//         Tensor<3> updated(const Tensor<3>& sigma, const Tensor<3>& strain) const { ... }
//     };

#include "material/hypoelastic.hpp"
#include "material/solidLaw.hpp"
#include "material/stressTensor.hpp"

namespace pfem {

/// What a rate law may look at besides stress and strain: its history variables (SolidLaw::historyNames) and the step
/// [s].
struct RateStep {
    std::span<const double> before;
    std::span<double> history;
    double dt = 0;
};

/// Law::updated(sigma, strain) or updated(sigma, strain, RateStep): the Cauchy stress after the step from the one
/// before and the strain of the step, in the frame halfway through the step's rotation: objective, as the law
/// hypoelastic (for which updated is sigma + C : strain). Written for space; 2D cases are in plane strain.
template <class Law>
class RateLaw : public SolidLawOf<Law> {
public:
    Kinematics kinematics() const override { return Kinematics::midpoint; }

    template <int Dim>
    void stressOf(const SolidPoints<Dim>& points) const {
        const int width = points.size() == 0 ? 0 : static_cast<int>(points.history.size()) / points.size();
        for (int p = 0; p < points.size(); ++p) {
            const Tensor<Dim>& increment = points.gradient[p];
            const Tensor<Dim> half = halfRotation<Dim>(increment);
            const Tensor<Dim> D = 0.5 * (increment + increment.transpose());
            const Tensor<Dim> turned = half * stressTensor<Dim>(points.sigma[p]) * half.transpose();
            const Tensor<3> before = inSpace<Dim>(turned, points.sigma[p][2]), strain = inSpace<Dim>(D, 0);
            Tensor<3> after;
            if constexpr (requires(const Law& law) { law.updated(before, strain); })
                after = this->law().updated(before, strain);
            else
                after = this->law().updated(
                    before, strain,
                    RateStep{ofPoint(points.before, width, p), ofPoint(points.history, width, p), points.dt});
            const Tensor<Dim> sum = half * after.template topLeftCorner<Dim, Dim>() * half.transpose();
            points.sigma[p] = packStress<Dim>(sum, after(2, 2));
        }
    }
    void predict(const SolidPoints<2>& points) const override { predicted<2>(points); }
    void predict(const SolidPoints<3>& points) const override { predicted<3>(points); }

private:
    template <int Dim>
    void predicted(const SolidPoints<Dim>& points) const {
        const IsotropicElasticity elastic = this->law().elasticity();
        for (int p = 0; p < points.size(); ++p)
            points.sigma[p] = rotatedMidpoint<Dim>(elastic, points.sigma[p], points.gradient[p]);
    }
};

}  // namespace pfem
