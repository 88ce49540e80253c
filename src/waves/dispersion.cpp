#include "waves/dispersion.hpp"

#include <cmath>

namespace pfem {

double waveNumber(double omega, double depth, double gravity) {
    const double deep = omega * omega * depth / gravity;  // q tanh q
    double q = deep / std::sqrt(std::tanh(deep));         // Eckart
    for (int n = 0; n < 20; ++n) {
        const double t = std::tanh(q), step = (q * t - deep) / (t + q * (1 - t * t));
        q -= step;
        if (std::abs(step) < 1e-15 * q) break;
    }
    return q / depth;
}

double makerGain(Maker maker, double q) {
    const bool deep = q > 20;  // where cosh 2q is as good as exp(2q)/2
    if (maker == Maker::piston) return deep ? 2 : 2 * (std::cosh(2 * q) - 1) / (std::sinh(2 * q) + 2 * q);
    if (deep) return 2 * (1 - 1 / q);
    return 4 * std::sinh(q) * (q * std::sinh(q) - std::cosh(q) + 1) / (q * (std::sinh(2 * q) + 2 * q));
}

double nearFieldGain(double q) {
    const double deep = q * std::tanh(q);
    double sum = 0;
    for (int j = 1; j <= 200; ++j) {  // terms fall with j^-3
        double low = (j - 0.5) * M_PI, high = j * M_PI;
        for (int n = 0; n < 60; ++n) {
            const double middle = 0.5 * (low + high);
            const bool above = middle * std::sin(middle) + deep * std::cos(middle) > 0;  // changes its sign with j
            (above == (j % 2 == 1) ? low : high) = middle;
        }
        const double s = std::sin(low);
        sum += 4 * s * s / (std::sin(2 * low) + 2 * low);
    }
    return sum;
}

}  // namespace pfem
