#pragma once
// Irregular seas as sums of sines.

#include <cstdint>
#include <vector>

namespace pfem {

/// amplitude sin(omega t + phase).
struct Sine {
    double amplitude, omega, phase;
};

/// Spectrum of JONSWAP up to a factor, r = f/f_peak:
///     r^-5 exp(-5/4 r^-4) gamma^exp(-(r - 1)^2/(2 s^2)),    s = 0.07 for r <= 1, else 0.09.
/// gamma = 1: that of Pierson and Moskowitz.
double jonswapShape(double r, double gamma);

/// A sea of the significant height H_m0 and peak period T_p.
struct Sea {
    double height = 0, period = 0;  // [m], [s]
    double gamma = 3.3;
    int components = 200;
    std::int64_t seed = 1;
};

/// Its surface at one place: sines of frequencies from 0.5 to 3 of the peak's, one at random in each of equal
/// intervals, with random phases; their variance is H_m0^2/16. The same numbers on every machine.
std::vector<Sine> surfaceOf(const Sea& sea);

/// The same amplitudes, their sum scaled to the crest, with the phases that meet at its time and place in water of this
/// depth (NewWave): a focused group.
struct Focus {
    double crest = 0, time = 0, place = 0;  // [m], [s], [m] from the wave maker
};
std::vector<Sine> focusedGroup(const Sea& sea, const Focus& focus, double depth, double gravity);

}  // namespace pfem
