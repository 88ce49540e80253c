#include <cmath>

#include "waves/permanentWave.hpp"

namespace pfem {

namespace {

/// Complete elliptic integrals of the first and second kind for the parameter m = 1 - m1, by Gauss' mean.
struct Elliptic {
    double K, E;
};
Elliptic elliptic(double m1) {
    double a = 1, b = std::sqrt(m1), c = std::sqrt(1 - m1), sum = 0.5 * c * c, power = 0.5;
    while (std::abs(c) > 1e-16) {
        const double mean = 0.5 * (a + b);
        c = 0.5 * (a - b);
        b = std::sqrt(a * b);
        a = mean;
        power *= 2;
        sum += power * c * c;
    }
    const double K = M_PI / (2 * a);
    return {K, K * (1 - sum)};
}

/// Wave length and speed for m1.
struct LengthAndSpeed {
    double length, speed;
};
LengthAndSpeed lengthAndSpeed(const RegularWave& wave, double m1) {
    const auto& [H, T, d, g] = wave;
    const auto [K, E] = elliptic(m1);
    const double m = 1 - m1;
    return {std::sqrt(16 * m * d * d * d / (3 * H)) * K, std::sqrt(g * d * (1 + H / (m * d) * (2 - m - 3 * E / K)))};
}

}  // namespace

PermanentWave cnoidalWave(const RegularWave& wave) {
    double low = std::log(1e-80), high = std::log(0.99);  // of m1; long waves have small ones
    for (int n = 0; n < 200; ++n) {
        const double middle = 0.5 * (low + high);
        const auto [length, speed] = lengthAndSpeed(wave, std::exp(middle));
        (speed * speed > 0 && length / speed < wave.period ? high : low) = middle;
    }
    const double m1 = std::exp(0.5 * (low + high)), m = 1 - m1;
    const auto [length, speed] = lengthAndSpeed(wave, m1);
    const double K = elliptic(m1).K, q = std::exp(-M_PI * elliptic(m).K / K);
    PermanentWave result{2 * M_PI / length, speed, {}};
    double power = 1;
    for (int n = 1; n <= 400; ++n) {
        power *= q;
        result.amplitude.push_back(wave.height * 2 * M_PI * M_PI / (m * K * K) * n * power / (1 - power * power));
        if (result.amplitude.back() < 1e-12 * wave.height) break;
    }
    return result;
}

}  // namespace pfem
