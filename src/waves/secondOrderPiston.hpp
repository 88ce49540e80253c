#pragma once
// What a piston must do beside its sine so that the waves carry no free second harmonic.

#include <complex>

namespace pfem {

/// Complex amplitude X_2 of the part of 2 omega, Re(X_1 e^{i omega t} + X_2 e^{2 i omega t}), to second order
/// (Schaeffer 1996, with all modes at the plate). With the wave numbers of omega, kappa_0 = k and kappa_j imaginary (g
/// kappa tanh kappa d = omega^2), the potential at first order is sum_j A_j f(kappa_j), f(K) = cosh K z/cosh K d exp(-i
/// K x), and pairs are bound to
///     B_jl = i omega A_j A_l (kappa_j kappa_l + kappa_l^2/2 - 3/2 omega^4/g^2)/(g K tanh K d - 4 omega^2),
/// K = kappa_j + kappa_l. At the plate, on the mode K_0 of 2 omega,
///     0 = <K_0, 2 i omega X_2 + X_1/2 sum_j kappa_j^2 A_j f(kappa_j) + i sum_jl K B_jl f(K)>.
std::complex<double> secondOrderStroke(std::complex<double> stroke, double omega, double depth, double gravity);

}  // namespace pfem
