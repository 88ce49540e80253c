#include "waves/spectrum.hpp"

#include <cmath>
#include <random>

#include "waves/dispersion.hpp"

namespace pfem {

namespace {

constexpr double lowest = 0.5, highest = 3;  // of the peak's frequency

/// From 0 to 1; std::uniform_real_distribution differs between libraries.
double random01(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Frequencies with the square root of the energy in their intervals as amplitudes, up to a factor; phases at random.
std::vector<Sine> sines(const Sea& sea) {
    std::mt19937_64 random(static_cast<std::uint64_t>(sea.seed));
    std::vector<Sine> all;
    for (int n = 0; n < sea.components; ++n) {
        const double r = lowest + (highest - lowest) * (n + random01(random)) / sea.components;
        const double phase = 2 * M_PI * random01(random);
        all.push_back({std::sqrt(jonswapShape(r, sea.gamma)), 2 * M_PI * r / sea.period, phase});
    }
    return all;
}

}  // namespace

double jonswapShape(double r, double gamma) {
    const double s = r <= 1 ? 0.07 : 0.09;
    return std::pow(r, -5) * std::exp(-1.25 * std::pow(r, -4)) *
           std::pow(gamma, std::exp(-(r - 1) * (r - 1) / (2 * s * s)));
}

std::vector<Sine> surfaceOf(const Sea& sea) {
    auto all = sines(sea);
    double variance = 0;
    for (const auto& sine : all) variance += 0.5 * sine.amplitude * sine.amplitude;
    for (auto& sine : all) sine.amplitude *= 0.25 * sea.height / std::sqrt(variance);
    return all;
}

std::vector<Sine> focusedGroup(const Sea& sea, const Focus& focus, double depth, double gravity) {
    auto all = sines(sea);
    double sum = 0;
    for (auto& sine : all) sum += sine.amplitude *= sine.amplitude;
    for (auto& sine : all) {
        sine.amplitude *= focus.crest / sum;
        sine.phase = M_PI / 2 - sine.omega * focus.time + waveNumber(sine.omega, depth, gravity) * focus.place;
    }
    return all;
}

}  // namespace pfem
