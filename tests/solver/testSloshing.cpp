// First sloshing mode of a tank, 1 m long, 0.5 m deep: omega^2 = g k tanh(k H), k = pi/L, T = 1.1818 s.

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TestCase tank(double h, double amplitude) {
    std::string vertices = "vertices ((0 0) (1 0)";
    const int n = static_cast<int>(std::lround(1 / h));
    for (int i = n; i >= 0; --i) {
        const double x = static_cast<double>(i) / n;
        vertices += " (" + std::to_string(x) + " " + std::to_string(0.5 + amplitude * std::cos(M_PI * x)) + ")";
    }
    return makeCase("meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " + vertices +
                        "); } ); walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                    water, "tank { type slip; }");
}

/// (2/L) integral of (eta - 0.5) cos(pi x / L) over the free surface.
double firstMode(const TestCase& c) {
    const auto topology = c.topology();
    double sum = 0;
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const Vec<2>& b = c.state.nodes.x[face.nodes[0]];  // fluid on the left: from right to left
        const Vec<2>& a = c.state.nodes.x[face.nodes[1]];
        const auto f = [](const Vec<2>& x) { return (x[1] - 0.5) * std::cos(M_PI * x[0]); };
        sum += (b[0] - a[0]) * (f(a) + f(b));
    }
    return sum;
}

struct Result {
    double period, drift, rawDrift, amplitude, late;
    int iterations, rejected;
};

Result run(double h, double dt, double endTime, double correctionTime, const char* integration = "nodal",
           const char* mass = "lumped") {
    TestCase c = tank(h, 0.01);
    c.controls.integration.integration = integration;
    c.controls.momentum.mass = mass;
    c.controls.continuity.volumeCorrectionTime = correctionTime;
    c.start(dt);
    const double volume = totalVolume<2>(c.state);
    std::vector<double> t, y;
    Result r{};
    int steps = 0;
    while (c.state.time.value < endTime - 0.5 * dt) {
        const auto report = c.step(dt);
        r.iterations += report.step.iterations;
        r.rejected += report.rejected;
        ++steps;
        t.push_back(c.state.time.value);
        y.push_back(firstMode(c));
        const double drift = c.ledgerSum() / volume;
        const double raw = drift - c.state.ledger[VolumeCause::correction] / volume;
        r.drift = std::max(r.drift, std::abs(drift));
        r.rawDrift = std::max(r.rawDrift, std::abs(raw));
        EXPECT_NEAR(totalVolume<2>(c.state) - volume, c.ledgerSum(), 1e-12);
    }
    const auto fit = fitHarmonic(t, y, 4.5, 6.2);
    r.period = 2 * M_PI / fit.omega;
    r.amplitude = fit.amplitude;
    const auto last = static_cast<std::size_t>(1.2 / dt);
    for (std::size_t i = y.size() - last; i < y.size(); ++i) r.late = std::max(r.late, std::abs(y[i]));
    std::cout << "h " << h << " dt " << dt << ": period " << r.period << " (" << 100 * (r.period / 1.1818 - 1)
              << " %), largest drift " << 100 * r.drift << " %, without correction's part " << 100 * r.rawDrift
              << " %, amplitude " << r.amplitude << ", in the last period " << r.late << ", iterations "
              << static_cast<double>(r.iterations) / steps << ", rejected " << r.rejected << "\n";
    for (const auto& [cause, amount] : c.state.ledger.byName())
        std::cout << "  " << cause << " " << 100 * amount / volume << " %\n";
    return r;
}

TEST(Sloshing, periodAndVolume) {
    const auto coarse = run(0.04, 0.01, 2.5, 0);
    EXPECT_NEAR(coarse.period, 1.1818, 0.01 * 1.1818);
    EXPECT_LT(coarse.drift, 2e-3);
    EXPECT_EQ(coarse.rejected, 0);
    EXPECT_GT(coarse.late, 0.0095);  // no damping
    EXPECT_LT(coarse.late, 0.0105);
    const auto fine = run(0.02, 5e-3, 5, 0);
    EXPECT_NEAR(fine.period, 1.1818, 0.01 * 1.1818);
    EXPECT_LT(fine.drift, 2e-3);
    EXPECT_EQ(fine.rejected, 0);
    EXPECT_GT(fine.late, 0.0095);
    EXPECT_LT(fine.late, 0.0105);
    EXPECT_LT(std::abs(fine.period - 1.1818), std::abs(coarse.period - 1.1818));
}

/// Steps as long as the return of lost volume: what comes back too fast makes waves grow.
TEST(Sloshing, longStepsStayStable) {
    for (const double dt : {0.015, 0.02}) EXPECT_LT(run(0.05, dt, 6.3, 0).late, 0.0108) << dt;
}

TEST(Sloshing, elementalFluid) {
    const auto r = run(0.04, 0.01, 2.5, 0, "elemental");
    EXPECT_NEAR(r.period, 1.1818, 0.01 * 1.1818);
    EXPECT_LT(r.drift, 2e-3);
    EXPECT_EQ(r.rejected, 0);
    EXPECT_GT(r.late, 0.0095);
    EXPECT_LT(r.late, 0.0105);
}

// Lumped, the half cells at the surface move as fast as it, not as their middle, h/3 below: they have rho k h^2/6 more
// inertia per area than the wave of rho/k, so that its period is (k h)^2/12 too long (0.8 % with 20 triangles a wave).
TEST(Sloshing, consistentMassKeepsThePeriod) {
    const auto lumped = run(0.1, 0.01, 2.5, 0), consistent = run(0.1, 0.01, 2.5, 0, "nodal", "consistent");
    EXPECT_GT(lumped.period, 1.006 * 1.1818);
    EXPECT_NEAR(consistent.period, 1.1818, 0.002 * 1.1818);
    EXPECT_LT(consistent.drift, 2e-3);
    EXPECT_EQ(consistent.rejected, 0);
    EXPECT_GT(consistent.late, 0.009);
    EXPECT_LT(consistent.late, 0.0105);
    EXPECT_LT(consistent.iterations, 1.5 * lumped.iterations);
}

// The same at h = 0.02 over 5 s: set PFEM_LONG_TESTS
TEST(Sloshing, elementalFluidFiner) {
    if (!std::getenv("PFEM_LONG_TESTS")) GTEST_SKIP() << "set PFEM_LONG_TESTS";
    const auto r = run(0.02, 5e-3, 5, 0, "elemental");
    EXPECT_NEAR(r.period, 1.1818, 0.01 * 1.1818);
    EXPECT_LT(r.drift, 2e-3);
    EXPECT_EQ(r.rejected, 0);
}

TEST(Sloshing, volumeCorrectionHoldsTheVolume) {
    const auto r = run(0.04, 0.01, 2.5, 0.05);
    EXPECT_NEAR(r.period, 1.1818, 0.01 * 1.1818);
    EXPECT_LT(r.drift, 2e-5);
    EXPECT_LT(r.rawDrift, 2e-3);
}

// set PFEM_LONG_TESTS
TEST(Sloshing, finer) {
    if (!std::getenv("PFEM_LONG_TESTS")) GTEST_SKIP() << "set PFEM_LONG_TESTS";
    const auto r = run(0.01, 2.5e-3, 5, 0);
    EXPECT_NEAR(r.period, 1.1818, 0.005 * 1.1818);
    EXPECT_LT(r.drift, 2e-3);
}

}  // namespace
