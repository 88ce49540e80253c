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

TestCase channel(const std::string& law, const std::string& integration, double h = 0.1) {
    TestCase c =
        makeCase("meshSize " + std::to_string(h) + "; bodies ( mud { type fluid; material mud; " +
                     rectangle(-W / 2, 0, W / 2, length) +
                     " } ); walls ( left { points ((-0.5 6) (-0.5 -2)); } right { points ((0.5 -2) (0.5 6)); } );",
                 "mud { rho 1000; " + law + " }", "left { type noSlip; } right { type noSlip; }", {0, -g});
    c.controls.integration.integration = integration;
    c.controls.convergence.accelerationDepth = 5;
    c.controls.convergence.maxIterations = 60;
    c.controls.remeshing.walls.wallTension = 1e3;  // it hangs on its walls
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
    while (c.state.time.value < end - 0.1 * dt) c.step(std::min(dt, end - c.state.time.value));
}

/// Largest error of u(y) half way up, in parts of the plug's speed.
double profileError(const TestCase& c, double plug, double mu, double halfPlug) {
    double worst = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (std::abs(x[1] - length / 2) > 0.4) continue;
        const double beyond = std::max(std::abs(x[0]) - halfPlug, 0.0);  // it lacks rho g beyond^2/(2 mu) of the plug
        worst = std::max(worst, std::abs(-c.state.nodes.v[i][1] - (plug - rho * g * beyond * beyond / (2 * mu))));
    }
    return worst / plug;
}

// On ten triangles across the nodal flow is too fast by 12 %, the elemental one by 6 %; when gravity goes it stops in
// time.
TEST(ChannelFlow, binghamStartsAndStops) {
    constexpr double mu = 500, tau0 = 200, plug = rho * g * 0.3 * 0.3 / (2 * mu);  // 0.09 m/s, |y| < 0.2
    const std::string law = "type bingham; mu 500; tau0 200; m 100;";
    TestCase nodal = channel(law, "nodal"), elemental = channel(law, "elemental");
    for (TestCase* c : {&nodal, &elemental}) run(*c, 1.2);
    std::cout << "plug, exact " << plug << ": " << speed(nodal, 0.16) << ", elemental " << speed(elemental, 0.16)
              << "; profile " << profileError(nodal, plug, mu, 0.2) << ", " << profileError(elemental, plug, mu, 0.2)
              << "\n";
    EXPECT_GT(speed(nodal, 0.16), speed(elemental, 0.16));
    EXPECT_NEAR(speed(nodal, 0.16), plug, 0.15 * plug);
    EXPECT_NEAR(speed(elemental, 0.16), plug, 0.08 * plug);
    EXPECT_LT(profileError(elemental, plug, mu, 0.2), 0.08);

    elemental.problem.gravity.setZero();
    const double norm = plug * std::sqrt(0.4 + 0.6 * 8.0 / 15) * std::sqrt(W);
    const double stop =
        rho * W * W / (M_PI * M_PI * mu) * std::log(1 + M_PI * M_PI * mu * norm / (2 * tau0 * std::pow(W, 1.5)));
    run(elemental, stop);
    EXPECT_LT(std::abs(speed(elemental, 0.16)), 0.02 * plug);
}

TEST(ChannelFlow, newtonianDoesNotStop) {
    constexpr double mu = 500, middle = rho * g * W * W / (8 * mu);
    TestCase c = channel("type newtonian; mu 500;", "nodal");
    run(c, 1.4);
    EXPECT_NEAR(speed(c, 0.06), middle, 0.05 * middle);
    const double before = speed(c, 0.06);
    c.problem.gravity.setZero();
    run(c, 0.14);
    EXPECT_NEAR(speed(c, 0.06) / before, 1.03 * std::exp(-M_PI * M_PI * mu * 0.14 / rho), 0.04);
}

TEST(ChannelFlow, herschelBulkleyPlug) {
    constexpr double k = 200, n = 0.5, tau0 = 200;
    const double plug = k / (rho * g) * n / (n + 1) * std::pow((rho * g * W / 2 - tau0) / k, (n + 1) / n);
    TestCase c = channel("type herschelBulkley; k 200; n 0.5; tau0 200; m 50;", "elemental");
    run(c, 1.5);
    std::cout << "plug " << speed(c, 0.16) << " exact " << plug << "\n";
    EXPECT_NEAR(speed(c, 0.16), plug, 0.1 * plug);
}

// Below the yield stress nothing moves: only the creep of the regularisation, u = rho g W^2/(8 m tau0).
TEST(ChannelFlow, heldByItsYieldStress) {
    TestCase c = channel("type bingham; mu 500; tau0 600; m 100;", "nodal");
    run(c, 0.5);
    EXPECT_LT(speed(c, 0.16), 3 * rho * g * W * W / (8 * 100 * 600));
}

}  // namespace
