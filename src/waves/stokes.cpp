#include <cmath>

#include "waves/permanentWave.hpp"

namespace pfem {

namespace {

/// a_0 + a_1 S + a_2 S^2 + ...
double polynomial(double S, std::initializer_list<double> a) {
    double sum = 0, power = 1;
    for (const double coefficient : a) {
        sum += coefficient * power;
        power *= S;
    }
    return sum;
}

/// Coefficients of Fenton's table 1 for q = k d: S = sech 2q, C = 1 - S.
struct Coefficients {
    double B22, B31, B42, B44, B53, B55, C0, C2, C4, D2, D4;

    explicit Coefficients(double q) {
        const double S = 1 / std::cosh(2 * q), C = 1 - S, coth = 1 / std::tanh(q), a = 3 + 2 * S, b = 4 + S;
        B22 = coth * (1 + 2 * S) / (2 * C);
        B31 = -3 * polynomial(S, {1, 3, 3, 2}) / (8 * std::pow(C, 3));
        B42 = coth * polynomial(S, {6, -26, -182, -204, -25, 26}) / (6 * a * std::pow(C, 4));
        B44 = coth * polynomial(S, {24, 92, 122, 66, 67, 34}) / (24 * a * std::pow(C, 4));
        B53 = 9 * polynomial(S, {132, 17, -2216, -5897, -6292, -2687, 194, 467, 82}) / (128 * a * b * std::pow(C, 6));
        B55 = 5 * polynomial(S, {300, 1579, 3176, 2949, 1188, 675, 1326, 827, 130}) / (384 * a * b * std::pow(C, 6));
        C0 = std::sqrt(std::tanh(q));
        C2 = C0 * polynomial(S, {2, 0, 7}) / (4 * C * C);
        C4 = C0 * polynomial(S, {4, 32, -116, -400, -71, 146}) / (32 * std::pow(C, 5));
        D2 = -0.5 * std::sqrt(coth);
        D4 = std::sqrt(coth) * polynomial(S, {2, 4, 1, 2}) / (8 * std::pow(C, 3));
    }
};

/// Speed for the wave number k, when no water is carried on the whole: sqrt(k/g) c = C0 + e^2 (C2 + D2/q) + e^4 ...
double stokesSpeed(const RegularWave& wave, double k) {
    const double q = k * wave.depth, e2 = std::pow(0.5 * k * wave.height, 2);
    const Coefficients f(q);
    return std::sqrt(wave.gravity / k) * (f.C0 + e2 * (f.C2 + f.D2 / q) + e2 * e2 * (f.C4 + f.D4 / q));
}

}  // namespace

PermanentWave stokesWave(const RegularWave& wave) {
    const double omega = 2 * M_PI / wave.period, deep = omega * omega / wave.gravity;
    double low = 0.3 * deep, high = 3 * std::max(deep, omega / std::sqrt(wave.gravity * wave.depth));
    for (int n = 0; n < 200; ++n) {  // k c(k) grows with k
        const double k = 0.5 * (low + high);
        (k * stokesSpeed(wave, k) > omega ? high : low) = k;
    }
    const double k = 0.5 * (low + high), e = 0.5 * k * wave.height;
    const Coefficients f(k * wave.depth);
    const double e2 = e * e, e3 = e2 * e, e4 = e2 * e2, e5 = e4 * e;
    PermanentWave result{k, omega / k, {}};
    for (const double part : {e + e3 * f.B31 - e5 * (f.B53 + f.B55), e2 * f.B22 + e4 * f.B42, -e3 * f.B31 + e5 * f.B53,
                              e4 * f.B44, e5 * f.B55})
        result.amplitude.push_back(part / k);
    return result;
}

}  // namespace pfem
