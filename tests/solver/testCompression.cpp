// A fluid that gives way to pressure loses no mass: the ledger tells compression from loss.

#include <gtest/gtest.h>

#include "functions/massBalance.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Fluid 0.5 m deep in a tank, as soft as 200 m of water deep, under a tenth of gravity at the start.
TestCase softFluid(double kappa) {
    TestCase c = makeCase("meshSize 0.05; bodies ( pool { type fluid; material water; " + rectangle(0, 0, 0.4, 0.5) +
                              " } ); walls ( tank { points ((0 1) (0 0) (0.4 0) (0.4 1)); } );",
                          "water { type newtonian; rho 1000; mu 20; kappa " + std::to_string(kappa) + "; }",
                          "tank { type slip; }", {0, -0.981});
    c.controls.timeIntegration.gamma = 1;
    c.start(2e-3);
    return c;
}

/// sum Omega_I (exp(p_I/kappa) - 1): what the fluid would have more of without its pressure.
double pressedAway(const State<2>& state, double kappa) {
    double sum = 0;
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell)
            sum += simplexMeasure<2>(state.nodes.x, cell) / 3 * std::expm1(state.nodes.p[i] / kappa);
    return sum;
}

TEST(Compression, isNoLoss) {
    const double kappa = 1e5;
    TestCase c = softFluid(kappa);
    const double first = totalVolume<2>(c.state), atStart = pressedAway(c.state, kappa);
    const MassAccount<2> account(c.state, {{"water", 1000}});
    c.problem.gravity = {0, -9.81};
    const double wanted = 0.5 * 0.9 * 9.81 * 1000 * 0.5 / kappa;  // mean change of pressure over kappa, at rest
    double largest = 0, mean = 0;
    for (int n = 0; n < 400; ++n) {  // it swings, four of the column's periods in all
        c.step(2e-3);
        double lost = 0;
        for (double amount : c.state.nodes.lostVolume) lost += amount;
        const auto balance = account.balance(c.state);
        const double compression = balance.causes.at("compression") / first;
        ASSERT_NEAR(totalVolume<2>(c.state) + lost, first * (1 + compression), 1e-12 * first);
        EXPECT_NEAR(compression, -(pressedAway(c.state, kappa) - atStart) / first, 0.05 * wanted);
        EXPECT_NEAR(balance.volume / first - 1, compression, 0.02 * wanted);  // the surface does not make up for it
        EXPECT_LT(std::abs(balance.relativeChange), 0.02 * wanted);
        EXPECT_LT(std::abs(balance.unexplained), 1e-12 * first);
        largest = std::max(largest, -compression);
        if (n >= 300) mean += compression / 100;
    }
    EXPECT_GT(largest, 1.5 * wanted);
    EXPECT_NEAR(mean, -wanted, 0.1 * wanted);
}

}  // namespace
