#pragma once
// Viscosity of a generalised Newtonian fluid: s = 2 mu(g) d', g = sqrt(2 d':d'), d' the deviator of the strain rate.

#include "base/types.hpp"
#include "material/material.hpp"

namespace pfem {

/// g = sqrt(2 d':d') of a velocity gradient [1/s]; 2D is plane strain.
template <int Dim>
double shearRate(const Tensor<Dim>& L);

/// mu(g) = tau0 (1 - exp(-m g)) / g + K g^(n-1) [Pa s]: Herschel and Bulkley's law with Papanastasiou's regularisation,
/// under which a fluid at rest creeps with the viscosity m tau0. Bingham: n = 1; Newtonian: tau0 = 0 too. n != 1: g of
/// the second term is sqrt(g^2 + 1/m^2).
double viscosity(const ViscousFluid& fluid, double shearRate);

/// d mu / d g [Pa s2].
double viscositySlope(const ViscousFluid& fluid, double shearRate);

/// s = 2 mu (d - tr(d)/3 I), in the plane.
template <int Dim>
Tensor<Dim> viscousStress(double mu, const Tensor<Dim>& L);

}  // namespace pfem
