// Wave makers that let waves out: an outlet whose level swings, with a waveSpeed, and a piston that gives way. What a
// wall throws back leaves through them, so that a train of a hundred periods neither grows nor drifts.

#include <gtest/gtest.h>

#include "support/flume.hpp"
#include "waves/dispersion.hpp"
#include "waves/reflection.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, d = 0.4;

/// Between an outlet whose level swings by twice c_g/c of the wave's amplitude, and a wall.
TestCase swingingLevel(double kd, double height, double length, double h) {
    const double k = kd / d, omega = std::sqrt(g * k * std::tanh(kd)), group = 0.5 * (1 + 2 * kd / std::sinh(2 * kd));
    TestCase c = makeCase(
        numbers("meshSize %; bodies ( water { type fluid; material water; ", {h}) + rectangle(0, 0, length, d) +
            numbers(" } ); walls ( left { points ((0 %) (0 0)); } bed { points ((0 0) (% 0)); } right { points ((% 0) "
                    "(% %)); } );",
                    {2 * d, length, length, length, 2 * d}),
        water,
        numbers("bed { type slip; } right { type slip; } left { type outlet; waveSpeed %; level { type sine; frequency "
                "%; scale %; level %; } }",
                {omega / k, omega / (2 * M_PI), group * height, d}),
        {0, -g});
    c.controls.timeIntegration.gamma = 0.5;
    c.start(2 * M_PI / omega / 60);
    return c;
}

/// Between a piston that makes waves and gives way to those that come, and a wall.
TestCase piston(double kd, double height, double length, double h) {
    const double T = 2 * M_PI / std::sqrt(g * kd / d * std::tanh(kd));
    TestCase c = makeCase(
        numbers("meshSize %; bodies ( water { type fluid; material water; ", {h}) + rectangle(0, 0, length, d) +
            numbers(" } ); walls ( left { moving true; points ((0 %) (0 0)); } tank { points ((-0.3 0) (% 0) (% %)); } "
                    ");",
                    {2 * d, length, length, 2 * d}),
        water,
        numbers("tank { type slip; } left { type slip; motion { displacement { type waveMaker; depth %; height %; "
                "period %; ramp %; } absorb { } } }",
                {d, height, T, 2 * T}),
        {0, -g});
    c.controls.timeIntegration.gamma = 0.5;
    c.start(T / 60);
    return c;
}

using Maker = TestCase (*)(double kd, double height, double length, double h);

// Before the wall crests are twice as high; with a piston that does not give way the waves would grow with each way to
// and fro.
void standsStill(const Maker& make, double kd, int periods) {
    const double k = kd / d, T = 2 * M_PI / std::sqrt(g * k * std::tanh(kd)), length = 2 * M_PI / k, height = 0.012,
                 L = 1.25 * length;
    TestCase c = make(kd, height, L, d / 8);
    while (c.state.time.value < 8 * T - 1e-9) c.step(T / 60);
    const std::vector<double> x{L - 0.01, L - 0.25 * length};  // a crest, and where the surface stays
    double first = 0, level = 0;
    for (int n = 8; n < periods; n += 4) {
        const auto A = harmonics(c, x, d, T, 4)[0];
        const double crest = std::abs(A[0]), mean = totalVolume<2>(c.state) / L;  // always at the same phase
        if (first == 0) first = crest, level = mean;
        EXPECT_NEAR(crest, height, 0.03 * height) << n;
        EXPECT_NEAR(crest, first, 0.01 * first) << n;
        EXPECT_LT(std::abs(A[1]), 0.02 * height) << n;
        EXPECT_NEAR(mean, level, 0.05 * height) << n;
    }
}

// A hundred periods: set PFEM_LONG_TESTS.
TEST(WaveTrains, aLevelThatSwingsLetsLongWavesOut) { standsStill(swingingLevel, 0.5, 16); }
TEST(WaveTrains, aLevelThatSwingsLetsWavesOut) {
    standsStill(swingingLevel, 1, std::getenv("PFEM_LONG_TESTS") ? 108 : 20);
}
TEST(WaveTrains, aPistonThatGivesWay) { standsStill(piston, 1, std::getenv("PFEM_LONG_TESTS") ? 108 : 20); }

}  // namespace
