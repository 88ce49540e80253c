#pragma once
// Hypoelastic solid (36)-(39): Cauchy stress from the strain increment of one step.

#include "base/types.hpp"
#include "material/material.hpp"

namespace pfem {

/// In-plane (2D) or full tensor of a stored stress.
template <int Dim>
Tensor<Dim> stressTensor(const Stress<Dim>& sigma);

/// Pressure p = -tr(sigma)/3, positive in compression, and deviator s = sigma + p I.
template <int Dim>
double pressure(const Stress<Dim>& sigma);
template <int Dim>
Stress<Dim> deviator(const Stress<Dim>& sigma);

/// sigma = s - p I.
template <int Dim>
Stress<Dim> withPressure(const Stress<Dim>& s, double p);

/// The stored form of a symmetric tensor; 2D: with its zz component, 3D: zz is not used.
template <int Dim>
Stress<Dim> packStress(const Tensor<Dim>& t, double zz);

/// C : D for isotropic elasticity (2D: plane strain, the zz component included).
template <int Dim>
Stress<Dim> elasticStress(const Hypoelastic& material, const Tensor<Dim>& D);

/// Rotated midpoint: sigma = R sigma^n R^T + R^{1/2} (C : D) R^{1/2 T}, with D and W the symmetric and skew part
/// of `increment` = grad of the step's displacement with midpoint gradients; R turns by 2 atan(|w|/2), the
/// exact angle of a rigid rotation. Objective: a stressed block turns without error.
template <int Dim>
Stress<Dim> rotatedMidpoint(const Hypoelastic& material, const Stress<Dim>& sigmaOld, const Tensor<Dim>& increment);

/// Half of that rotation, R^{1/2}.
template <int Dim>
Tensor<Dim> halfRotation(const Tensor<Dim>& increment);

/// (39) as printed: sigma = sigma^n + C : (dt d(v^{n+1})), end-point gradients, no rotation. For comparison.
template <int Dim>
Stress<Dim> paperUpdate(const Hypoelastic& material, const Stress<Dim>& sigmaOld, const Tensor<Dim>& gradV, double dt);

}  // namespace pfem
