#pragma once
// Hypoelastic solid (36)-(39): Cauchy stress from the strain increment of one step.

#include "material/solidLaw.hpp"
#include "material/stressTensor.hpp"

namespace pfem {

/// C : D for isotropic elasticity (2D: plane strain, the zz component included).
template <int Dim>
Stress<Dim> elasticStress(const IsotropicElasticity& elastic, const Tensor<Dim>& D);

/// Rotated midpoint: sigma = R sigma^n R^T + R^{1/2} (C : D) R^{1/2 T}, with D and W the symmetric and skew part
/// of `increment` = grad of the step's displacement with midpoint gradients; R turns by 2 atan(|w|/2), the
/// exact angle of a rigid rotation. Objective: a stressed block turns without error.
template <int Dim>
Stress<Dim> rotatedMidpoint(const IsotropicElasticity& elastic, const Stress<Dim>& sigmaOld,
                            const Tensor<Dim>& increment);

/// Half of that rotation, R^{1/2}.
template <int Dim>
Tensor<Dim> halfRotation(const Tensor<Dim>& increment);

/// (39) as printed: sigma = sigma^n + C : (dt d(v^{n+1})), end-point gradients, no rotation. For comparison.
template <int Dim>
Stress<Dim> paperUpdate(const IsotropicElasticity& elastic, const Stress<Dim>& sigmaOld, const Tensor<Dim>& gradV,
                        double dt);

/// The law `hypoelastic`: the rotated midpoint.
class Hypoelastic : public SolidLawOf<Hypoelastic> {
public:
    IsotropicElasticity elastic;

    template <class Visitor>
    void entries(Visitor& v) {
        elastic.entries(v);
    }
    Kinematics kinematics() const override { return Kinematics::midpoint; }
    IsotropicElasticity elasticity() const override { return elastic; }

    template <int Dim>
    void stressOf(const SolidPoints<Dim>& points) const {
        for (int p = 0; p < points.size(); ++p)
            points.sigma[p] = rotatedMidpoint<Dim>(elastic, points.sigma[p], points.gradient[p]);
    }
};

/// The law `hypoelasticPaper`.
class HypoelasticPaper : public SolidLawOf<HypoelasticPaper> {
public:
    IsotropicElasticity elastic;

    template <class Visitor>
    void entries(Visitor& v) {
        elastic.entries(v);
    }
    Kinematics kinematics() const override { return Kinematics::endPoint; }
    IsotropicElasticity elasticity() const override { return elastic; }

    template <int Dim>
    void stressOf(const SolidPoints<Dim>& points) const {
        for (int p = 0; p < points.size(); ++p)
            points.sigma[p] = paperUpdate<Dim>(elastic, points.sigma[p], points.gradient[p], points.dt);
    }
};

}  // namespace pfem
