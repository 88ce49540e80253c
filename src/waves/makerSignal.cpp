#include "waves/makerSignal.hpp"

#include <cmath>

#include "waves/secondOrderPiston.hpp"

namespace pfem {

std::vector<Sine> motionFor(const std::vector<Sine>& surface, const Flume& flume) {
    std::vector<Sine> motion = surface;
    for (auto& sine : motion) {
        sine.amplitude /= makerGain(flume.maker, waveNumber(sine.omega, flume.depth, flume.gravity) * flume.depth);
        sine.phase -= M_PI / 2;  // the surface at the maker goes with its velocity
    }
    return motion;
}

std::vector<Sine> inflowFor(const std::vector<Sine>& surface, const Flume& flume) {
    std::vector<Sine> inflow = surface;
    for (auto& sine : inflow) sine.amplitude *= sine.omega / waveNumber(sine.omega, flume.depth, flume.gravity);
    return inflow;
}

std::vector<Sine> regularMotion(double height, double period, bool secondOrder, const Flume& flume) {
    const double omega = 2 * M_PI / period, d = flume.depth, q = waveNumber(omega, d, flume.gravity) * d,
                 gain = makerGain(flume.maker, q);
    std::vector<Sine> motion{{0.5 * height / gain, omega, 0}};
    if (secondOrder) {
        const std::complex<double> i(0, 1), first = -i * motion[0].amplitude;  // a sine
        const auto second = secondOrderStroke(first, omega, d, flume.gravity);
        motion.push_back({std::abs(second), 2 * omega, std::arg(i * second)});
    }
    return motion;
}

std::vector<Sine> surfaceAtPiston(const std::vector<Sine>& motion, const Flume& flume) {
    std::vector<Sine> surface = motion;
    for (auto& sine : surface) {
        const double q = waveNumber(sine.omega, flume.depth, flume.gravity) * flume.depth;
        const double away = makerGain(Maker::piston, q), near = nearFieldGain(q);
        sine.amplitude *= std::hypot(away, near);
        sine.phase += std::atan2(away, near);  // sin + pi/2 is the velocity's phase
    }
    return surface;
}

std::vector<Sine> regularSurface(double height, double period, bool secondOrder, const Flume& flume) {
    auto surface = surfaceAtPiston(regularMotion(height, period, false, flume), flume);
    if (!secondOrder) return surface;
    const double omega = 2 * M_PI / period, k = waveNumber(omega, flume.depth, flume.gravity), q = k * flume.depth;
    const double bound = k * height * height / 16 * std::cosh(q) * (2 + std::cosh(2 * q)) / std::pow(std::sinh(q), 3);
    surface.push_back({bound, 2 * omega, M_PI / 2});  // its crests are those of the waves, H/2 cos wt
    return surface;
}

SolitaryMotion::SolitaryMotion(double height, const Flume& flume)
    : a_(height),
      d_(flume.depth),
      c_(std::sqrt(flume.gravity * (d_ + a_))),
      K_(std::sqrt(3 * a_ / (4 * d_ * d_ * (d_ + a_)))) {}

/// theta = K (c (t - t0) - X) with X = a/(K d) tanh theta: theta + a/d tanh theta = K c (t - t0), which grows.
double SolitaryMotion::phaseAt(double t) const {
    const double rest = std::atanh(0.998);  // 0.1 % of the stroke, 2 a/(K d)
    const double wanted = K_ * c_ * t - rest - a_ / d_ * 0.998;
    double theta = wanted / (1 + a_ / d_);
    for (int n = 0; n < 60; ++n) {
        const double th = std::tanh(theta);
        const double step = (theta + a_ / d_ * th - wanted) / (1 + a_ / d_ * (1 - th * th));
        theta -= step;
        if (std::abs(step) < 1e-14 * (1 + std::abs(theta))) break;
    }
    return theta;
}

double SolitaryMotion::value(double t) const {
    if (t <= 0) return 0;
    return a_ / (K_ * d_) * (std::tanh(phaseAt(t)) + 0.998);
}

double SolitaryMotion::surface(double t) const {
    if (t <= 0) return 0;
    const double sech = 1 / std::cosh(phaseAt(t));
    return a_ * sech * sech;
}

double sumAt(const std::vector<Sine>& sines, double t) {
    double sum = 0;
    for (const auto& s : sines) sum += s.amplitude * std::sin(s.omega * t + s.phase);
    return sum;
}

double rateAt(const std::vector<Sine>& sines, double t) {
    double sum = 0;
    for (const auto& s : sines) sum += s.amplitude * s.omega * std::cos(s.omega * t + s.phase);
    return sum;
}

}  // namespace pfem
