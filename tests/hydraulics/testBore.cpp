// A stream that meets a wall: a bore goes back from it. Beside the bore it is a hydraulic jump, without sluice and tail
// water: depth and speed follow from volume and momentum alone.

#include <gtest/gtest.h>

#include "functions/momentumBalance.hpp"
#include "functions/waveGauge.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, y1 = 0.05, length = 3;
constexpr double mixing = 0.007;  // eddy viscosity over u1 y1: a plane flow has no turbulence that evens velocities

/// The water's depth above x, without voids.
double depthAt(const TestCase& c, double x) {
    const auto reading = readGauge<2>(c.state, {x, 0}, {0, 1});
    return reading ? reading->depth : 0;
}

double meanDepth(const TestCase& c, double from, double to) {
    constexpr int places = 40;
    double sum = 0;
    for (int k = 0; k < places; ++k) sum += depthAt(c, from + (to - from) * (k + 0.5) / places);
    return sum / places;
}

/// Where the water is deeper for the first time.
double frontOf(const TestCase& c, double depth) {
    for (double x = 0.05; x < length; x += 0.01)
        if (depthAt(c, x) > depth) return x;
    return length;
}

/// Of the straight line with the least squares.
double slopeOf(const std::vector<double>& x, const std::vector<double>& y) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        n += 1;
        sx += x[k];
        sy += y[k];
        sxx += x[k] * x[k];
        sxy += x[k] * y[k];
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Belanger's ratio of depths for the Froude number of the stream beside the bore.
double conjugate(double Fr) { return 0.5 * (std::sqrt(1 + 8 * Fr * Fr) - 1); }

struct Bore {
    double depth, speed;  // behind it; upstream
    double lost;          // of the momentum, in parts of what the wall has taken
};

/// The bore between the times at which it should be 1.2 m and 2.4 m from the wall.
Bore boreOf(double Fr, double h) {
    const double ratio = conjugate(Fr), beside = Fr * std::sqrt(g * y1), w = beside / ratio, u = beside - w;
    TestCase c = makeCase(
        "meshSize " + std::to_string(h) + "; bodies ( stream { type fluid; material water; " +
            rectangle(0, 0, length, y1) + " velocity (" + std::to_string(u) +
            " 0); } ); walls ( gate { points ((0 1) (0 0.05)); } sluice { points ((0 0.05) (0 0)); } "
            "bed { points ((0 0) (3 0) (3 2)); } );",
        "water { type newtonian; rho 1000; kappa 2.1e9; mu " + std::to_string(mixing * 1000 * beside * y1) + "; }",
        "gate { type slip; } bed { type slip; } sluice { type inlet; velocity " + std::to_string(u) + "; }", {0, -g});
    c.start(1e-3);
    const ControlVolume<2> volume{{0.3, 0}, {1, 0}, 2 * length, 4 * h};
    const auto sum = [](const std::array<double, 7>& rates) {
        double all = 0;
        for (const double rate : rates) all += rate;
        return all;
    };
    const double first = momentumIn<2>(c.problem, c.state, volume);
    auto rates = momentumRates<2>(c.problem, c.controls, c.state, volume);
    double brought = 0, byWall = 0;
    std::vector<double> times, fronts;
    while (c.state.time.value < 2.4 / w) {
        const double t = c.state.time.value;
        c.step(std::min(0.01, 0.4 / courantRate<2>(c.state).largest));
        const auto now = momentumRates<2>(c.problem, c.controls, c.state, volume);
        const double dt = c.state.time.value - t;
        brought += 0.5 * dt * (sum(rates.all()) + sum(now.all()));
        byWall += 0.5 * dt * (rates.walls + now.walls);
        rates = now;
        if (c.state.time.value < 1.2 / w) continue;
        times.push_back(c.state.time.value);
        fronts.push_back(frontOf(c, 0.5 * (1 + ratio) * y1));
    }
    return {meanDepth(c, length - 1.0, length - 0.2), -slopeOf(times, fronts),
            (momentumIn<2>(c.problem, c.state, volume) - first - brought) / byWall};
}

TEST(Bore, againstAWall) {
    constexpr double Fr = 2;
    const Bore bore = boreOf(Fr, y1 / 4);
    const double ratio = conjugate(Fr), w = Fr * std::sqrt(g * y1) / ratio;
    EXPECT_NEAR(bore.depth, ratio * y1, 0.02 * ratio * y1);
    EXPECT_NEAR(bore.speed, w, 0.03 * w);
    EXPECT_NEAR(bore.lost, 0, 0.01);
}

}  // namespace
