// Fluids with yield stress between two vertical plates, a distance W apart, that start to fall under their weight and,
// when gravity is switched off, stop. Half way between top and bottom the flow is plane: u(y), y from the middle.
//
//   steady (Herschel-Bulkley):  plug of |y| < tau0/(rho g), u = k/(rho g) n/(n+1) ((rho g W/2 - tau0)/k)^((n+1)/n)
//   stopping of Bingham's:      before rho W^2/(pi^2 mu) ln(1 + pi^2 mu |u0| / (2 tau0 W^(3/2))), |u0| the L2 norm
//   stopping of Newton's:       exp(- pi^2 mu t/(rho W^2))

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double W = 1, rho = 1000, g = 1, length = 4, dt = 0.01;

TestCase channel(const std::string& law, const std::string& integration) {
    TestCase c = makeCase("meshSize 0.1; bodies ( mud { type fluid; material mud; " +
                              rectangle(-W / 2, 0, W / 2, length) +
                              " } ); walls ( left { points ((-0.5 6) (-0.5 -2)); } right { points ((0.5 -2) (0.5 6)); } );",
                          "mud { rho 1000; " + law + " }", "left { type noSlip; } right { type noSlip; }", {0, -g});
    c.controls.integration.integration = integration;
    c.tolerance(1e-5);
    return c;
}

/// Mean of -v_y of the nodes half way up with |y| <= width.
double speed(const TestCase& c, double width) {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (std::abs(x[1] - length / 2) > 0.4 || std::abs(x[0]) > width) continue;
        sum -= c.state.nodes.v[i][1];
        ++count;
    }
    EXPECT_GT(count, 5);
    return sum / count;
}

void run(TestCase& c, double time) {
    const double end = c.state.time.value + time;
    while (c.state.time.value < end - 0.5 * dt) EXPECT_EQ(c.step(dt).rejected, 0);
}

class Channel : public testing::TestWithParam<const char*> {};

TEST_P(Channel, binghamStartsAndStops) {
    constexpr double mu = 500, tau0 = 200, plug = rho * g * 0.3 * 0.3 / (2 * mu);  // 0.09 m/s, |y| < 0.2
    TestCase c = channel("type bingham; mu 500; tau0 200; m 1000;", GetParam());
    run(c, 1.2);
    std::cout << GetParam() << ": plug " << speed(c, 0.16) << " exact " << plug << "\n";
    EXPECT_NEAR(speed(c, 0.16), plug, 0.03 * plug);
    // u(y) beside the plug: at |y| = 0.35 it lacks rho g (0.15)^2/(2 mu)
    double worst = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (std::abs(x[1] - length / 2) > 0.4) continue;
        const double beyond = std::max(std::abs(x[0]) - 0.2, 0.0);
        worst = std::max(worst, std::abs(-c.state.nodes.v[i][1] - (plug - rho * g * beyond * beyond / (2 * mu))));
    }
    EXPECT_LT(worst, 0.05 * plug);

    c.problem.gravity.setZero();
    const double norm = plug * std::sqrt(0.4 + 0.6 * 8.0 / 15) * std::sqrt(W);
    const double stop = rho * W * W / (M_PI * M_PI * mu) * std::log(1 + M_PI * M_PI * mu * norm / (2 * tau0 * std::pow(W, 1.5)));
    run(c, std::ceil(stop / dt) * dt);
    std::cout << GetParam() << ": after " << stop << " s " << speed(c, 0.16) / plug << "\n";
    EXPECT_LT(std::abs(speed(c, 0.16)), 0.02 * plug);
}

TEST(ChannelFlow, newtonianDoesNotStop) {
    constexpr double mu = 500, middle = rho * g * W * W / (8 * mu);
    TestCase c = channel("type newtonian; mu 500;", "nodal");
    run(c, 1.4);
    EXPECT_NEAR(speed(c, 0.06), middle, 0.03 * middle);
    const double before = speed(c, 0.06);
    c.problem.gravity.setZero();
    run(c, 0.14);
    EXPECT_NEAR(speed(c, 0.06) / before, 1.03 * std::exp(-M_PI * M_PI * mu * 0.14 / rho), 0.03);
}

TEST_P(Channel, herschelBulkleyPlug) {
    constexpr double k = 200, n = 0.5, tau0 = 200;
    const double plug = k / (rho * g) * n / (n + 1) * std::pow((rho * g * W / 2 - tau0) / k, (n + 1) / n);
    TestCase c = channel("type herschelBulkley; k 200; n 0.5; tau0 200; m 1000;", GetParam());
    run(c, 1.5);
    std::cout << GetParam() << ": plug " << speed(c, 0.16) << " exact " << plug << "\n";
    EXPECT_NEAR(speed(c, 0.16), plug, 0.05 * plug);
}

// Below the yield stress nothing moves: only the creep of the regularisation, u = rho g W^2/(8 m tau0).
TEST(ChannelFlow, heldByItsYieldStress) {
    TestCase c = channel("type bingham; mu 500; tau0 600; m 1000;", "nodal");
    run(c, 0.5);
    EXPECT_LT(speed(c, 0.16), 3 * rho * g * W * W / (8 * 1000 * 600));
}

INSTANTIATE_TEST_SUITE_P(integrations, Channel, testing::Values("nodal", "elemental"));

}  // namespace
