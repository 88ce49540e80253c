#pragma once
// The stored form of a stress and its parts.

#include "base/types.hpp"

namespace pfem {

/// In-plane (2D) or full tensor of a stored stress.
template <int Dim>
Tensor<Dim> stressTensor(const Stress<Dim>& sigma);

/// The stored form of a symmetric tensor; 2D: with its zz component, 3D: zz is not used.
template <int Dim>
Stress<Dim> packStress(const Tensor<Dim>& t, double zz);

/// Pressure p = -tr(sigma)/3, positive in compression, and deviator s = sigma + p I.
template <int Dim>
double pressure(const Stress<Dim>& sigma);
template <int Dim>
Stress<Dim> deviator(const Stress<Dim>& sigma);

/// sigma = s - p I.
template <int Dim>
Stress<Dim> withPressure(const Stress<Dim>& s, double p);

/// A tensor of the plane with `zz` in the third direction; 3D: as it is.
template <int Dim>
Tensor<3> inSpace(const Tensor<Dim>& t, double zz);

/// The stored form of a symmetric tensor of space (2D: that of plane strain).
template <int Dim>
Stress<Dim> stored(const Tensor<3>& sigma);

}  // namespace pfem
