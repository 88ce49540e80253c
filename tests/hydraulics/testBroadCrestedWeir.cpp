// Water over a broad crest without friction, a parabola: its head tells the flow, q = (2/3)^1.5 sqrt(g) H^1.5 (1.705
// H^1.5 in SI), and at the crown it has the critical depth (q^2/g)^(1/3). On a level crest a head that is 1 % larger
// lets the depth be 10 % larger or less; a crown tells the place where it is critical.

#include <gtest/gtest.h>

#include "functions/waveGauge.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, yc = 0.05, P = 0.1, halfLength = 0.6;
const std::string bedOfX = "(x < -0.6 ? 0 : 0.1 - x*x/3.6)",
                  surfaceOfX = "(x < -0.2 ? 0.175 : x < 0 ? 0.15 - x/8 : 0.15 - x*x/3.6 - x/20)";

std::string point(double x, double y) { return "(" + std::to_string(x) + " " + std::to_string(y) + ") "; }

/// Pieces of 50 mm, less than two degrees each.
std::string bed() {
    std::string points = point(-1, 0);
    for (int k = -12; k <= 12; ++k) points += point(halfLength * k / 12, P - P * k * k / 144.0);
    return points;
}

/// From the outlet upstream.
std::string surface() {
    std::string points;
    for (const double x : {0.6, 0.4, 0.2, 0.0}) points += point(x, P + yc - x * x / 3.6 - x / 20);
    return points + point(-0.2, 0.175) + point(-1, 0.175);
}

/// Head and depth at the crown, means of the last 2.5 of 5 s.
struct Flow {
    double head = 0, crown = 0;
};
Flow flowOver(double q, double h) {
    TestCase c = makeCase(
        "meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; vertices (" + bed() +
            surface() + "); velocity expression (\"" + std::to_string(q) + "/(" + surfaceOfX + " - " + bedOfX +
            ")\" \"0\"); } ); walls ( inlet { points ((-1 0.4) (-1 0)); } bed { points (" + bed() +
            "); } end { points ((0.6 0) (0.6 0.3)); } );",
        water, "inlet { type inlet; flowRate " + std::to_string(q) + "; } bed { type slip; } end { type outlet; }",
        {0, -g});
    c.start(1e-3);
    const auto depthAt = [&](double x) { return readGauge<2>(c.state, {x, -0.1}, {0, 1})->depth; };
    Flow flow;
    int count = 0;
    while (c.state.time.value < 5) {
        c.step(std::min(0.01, 0.4 / courantRate<2>(c.state).largest));
        if (c.state.time.value < 2.5) continue;
        const double above = depthAt(-0.8);
        flow.head += above - P + q * q / (2 * g * above * above);
        for (const double x : {-0.04, -0.02, 0.0, 0.02, 0.04}) flow.crown += depthAt(x) / 5;
        ++count;
    }
    return {flow.head / count, flow.crown / count};
}

TEST(BroadCrestedWeir, criticalDepthOnTheCrest) {
    const double q = std::sqrt(g * yc * yc * yc);
    const Flow flow = flowOver(q, 0.0125);
    const double byHead = std::pow(2.0 / 3, 1.5) * std::sqrt(g) * std::pow(flow.head, 1.5);
    EXPECT_NEAR(q, byHead, 0.03 * q);
    EXPECT_NEAR(flow.crown, yc, 0.03 * yc);
}

}  // namespace
