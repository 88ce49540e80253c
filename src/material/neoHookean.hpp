#pragma once
// Compressible neo-Hookean solid, from the deformation gradient alone: W = mu/2 (tr b - 3) - mu ln J + lambda/2 (ln
// J)^2 with b = F F^T, J = det F. It has the elastic constants of the hypoelastic law and agrees with it at small
// strain. 2D is plane strain: F_zz = 1.

#include "base/types.hpp"
#include "material/material.hpp"

namespace pfem {

/// sigma = (mu (b - I) + lambda ln J I) / J. Throws StepFailure unless J > 0.
template <int Dim>
Stress<Dim> neoHookeanStress(const Hypoelastic& material, const Tensor<Dim>& F);

/// The two parts of sigma: mu (b - I) / J, and - p I with p = - lambda ln J / J. Where volumes are counted at the nodes
/// (velocityPressure) each has its own J. Both throw StepFailure unless J > 0.
template <int Dim>
Stress<Dim> neoHookeanShear(const Hypoelastic& material, const Tensor<Dim>& F);
double neoHookeanPressure(const Hypoelastic& material, double J);

/// The two parts of W: mu/2 (tr b - 3) - mu ln J, and lambda/2 (ln J)^2.
template <int Dim>
double neoHookeanShearEnergy(const Hypoelastic& material, const Tensor<Dim>& F);
double neoHookeanVolumeEnergy(const Hypoelastic& material, double J);

/// W per reference volume [J/m3]: dW/dF = P.
template <int Dim>
double neoHookeanEnergy(const Hypoelastic& material, const Tensor<Dim>& F);

/// First Piola stress P = J sigma F^{-T} (2D: in the plane): force per reference area.
template <int Dim>
Tensor<Dim> firstPiola(const Stress<Dim>& sigma, const Tensor<Dim>& F);

}  // namespace pfem
