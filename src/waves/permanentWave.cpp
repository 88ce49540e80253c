#include "waves/permanentWave.hpp"

#include <cmath>

namespace pfem {

double PermanentWave::surface(double theta) const {
    double sum = 0;
    for (std::size_t j = 0; j < amplitude.size(); ++j)
        sum += amplitude[j] * std::cos(static_cast<double>(j + 1) * theta);
    return sum;
}

double PermanentWave::integral(double theta) const {
    double sum = 0;
    for (std::size_t j = 0; j < amplitude.size(); ++j) {
        const auto n = static_cast<double>(j + 1);
        sum += amplitude[j] / n * std::sin(n * theta);
    }
    return sum;
}

double ursell(const PermanentWave& wave, const RegularWave& of) {
    const double length = 2 * M_PI / wave.k;
    return of.height * length * length / (of.depth * of.depth * of.depth);
}

double PermanentMotion::phaseAt(double t) const {
    const double wanted = wave_.k * wave_.c * t;
    double theta = wanted, low = wanted - M_PI, high = wanted + M_PI;  // |I| < pi d: the water has a depth everywhere
    for (int n = 0; n < 100; ++n) {                                    // theta + I/d grows
        const double excess = theta + wave_.integral(theta) / depth_ - wanted;
        (excess > 0 ? high : low) = theta;
        const double step = excess / (1 + wave_.surface(theta) / depth_);
        const double next = theta - step > low && theta - step < high ? theta - step : 0.5 * (low + high);
        if (std::abs(next - theta) < 1e-14 * (1 + std::abs(theta))) break;
        theta = next;
    }
    return theta;
}

double PermanentMotion::value(double t) const { return wave_.integral(phaseAt(t)) / (wave_.k * depth_); }

}  // namespace pfem
