#pragma once
// Shear rate and stress of a viscous flow: s = 2 mu d', d' the deviator of the strain rate.

#include "base/types.hpp"

namespace pfem {

/// g = sqrt(2 d':d') of a velocity gradient [1/s]; 2D is plane strain.
template <int Dim>
double shearRate(const Tensor<Dim>& L);

/// s = 2 mu (d - tr(d)/3 I), in the plane.
template <int Dim>
Tensor<Dim> viscousStress(double mu, const Tensor<Dim>& L) {
    return mu * (L + L.transpose()) - (2 * mu / 3) * L.trace() * Tensor<Dim>::Identity();
}

}  // namespace pfem
