#pragma once
// Which part of the waves goes and which comes back, from gauges in a row.

#include <complex>
#include <optional>
#include <vector>

namespace pfem {

/// Complex amplitudes at x = 0 of waves that go along x and against it.
struct Waves {
    std::complex<double> incident, reflected;
};

/// Least squares over the gauges at x [m] of
///     eta_m = Re(A_m exp(i omega t)),   A_m = I exp(-i k x_m) + R exp(i k x_m)
/// (two gauges: Goda and Suzuki; three and more: Mansard and Funke). None where the gauges hardly tell both apart:
/// their distances are near to multiples of half a wave length.
std::optional<Waves> separateWaves(const std::vector<double>& x, const std::vector<std::complex<double>>& A, double k);

}  // namespace pfem
