#include "waves/secondOrderPiston.hpp"

#include <cmath>
#include <vector>

#include "waves/dispersion.hpp"

namespace pfem {

namespace {

using Complex = std::complex<double>;
constexpr int nEvanescent = 40;

/// k, then -i s with s tan s d = - omega^2/g.
std::vector<Complex> waveNumbers(double omega, double d, double g) {
    std::vector<Complex> kappa{waveNumber(omega, d, g)};
    const double deep = omega * omega * d / g;
    for (int j = 1; j <= nEvanescent; ++j) {
        double low = (j - 0.5) * M_PI, high = j * M_PI;  // of s d
        const double side = low * std::sin(low);         // cos low = 0
        for (int n = 0; n < 60; ++n) {
            const double y = 0.5 * (low + high);
            ((y * std::sin(y) + deep * std::cos(y)) * side > 0 ? low : high) = y;
        }
        kappa.emplace_back(0, -0.5 * (low + high) / d);
    }
    return kappa;
}

/// int_0^d cosh a z cosh b z dz, a != b.
Complex overlap(Complex a, Complex b, double d) {
    return (a * std::sinh(a * d) * std::cosh(b * d) - b * std::cosh(a * d) * std::sinh(b * d)) / (a * a - b * b);
}

}  // namespace

Complex secondOrderStroke(Complex stroke, double omega, double d, double g) {
    const Complex i(0, 1);
    const auto kappa = waveNumbers(omega, d, g);
    const Complex K0 = waveNumber(2 * omega, d, g);
    std::vector<Complex> A;
    for (const Complex k : kappa)
        A.push_back(-omega * stroke / k * std::cosh(k * d) * (std::sinh(k * d) / k) /
                    (0.5 * d * (1.0 + std::sinh(2.0 * k * d) / (2.0 * k * d))));
    const double deep = std::pow(omega, 4) / (g * g);
    Complex sum = 0;
    for (std::size_t j = 0; j < kappa.size(); ++j) {
        sum += 0.5 * stroke * kappa[j] * kappa[j] * A[j] * overlap(K0, kappa[j], d) / std::cosh(kappa[j] * d);
        for (std::size_t l = 0; l < kappa.size(); ++l) {
            const Complex K = kappa[j] + kappa[l];
            const Complex bound = i * omega * A[j] * A[l] *
                                  (kappa[j] * kappa[l] + 0.5 * kappa[l] * kappa[l] - 1.5 * deep) /
                                  (g * K * std::tanh(K * d) - 4 * omega * omega);
            sum += i * K * bound * overlap(K0, K, d) / std::cosh(K * d);
        }
    }
    return -sum / (2.0 * i * omega * (std::sinh(K0 * d) / K0));
}

}  // namespace pfem
