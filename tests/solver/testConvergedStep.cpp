// What shapes the path of the iteration must not move its end.

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Water beside and over a soft solid step in a tank, in motion.
TestCase smallFsi() {
    TestCase c = waterBesideStep();
    c.start(1e-3);
    for (int n = 0; n < 20; ++n) c.step(2e-3);
    c.tolerance(1e-10);
    c.controls.momentum.linearTolerance = 1e-10;
    return c;
}

struct Change {
    const char* name;
    void (*apply)(Controls&);
};
std::ostream& operator<<(std::ostream& out, const Change& change) { return out << change.name; }

class ConvergedStep : public testing::TestWithParam<Change> {};

TEST_P(ConvergedStep, isTheSame) {
    TestCase c = smallFsi();
    const auto topology = c.topology();
    const auto constraints = c.constraints(topology);
    const auto step = [&](const Controls& controls) {
        const double gamma = controls.timeIntegration.gamma;
        return fsiStep<2>({c.problem, c.state.mesh, topology, constraints, c.state.nodes, {2e-3, gamma}}, controls);
    };
    const auto base = step(c.controls);
    Controls changed = c.controls;
    GetParam().apply(changed);
    const auto other = step(changed);
    double dv = 0, dp = 0, ds = 0, s = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        dv = std::max(dv, (base.nodes.v[i] - other.nodes.v[i]).norm());
        dp = std::max(dp, std::abs(base.nodes.p[i] - other.nodes.p[i]));
        ds = std::max(ds, (base.nodes.sigma[i] - other.nodes.sigma[i]).norm());
        s = std::max(s, base.nodes.sigma[i].norm());
    }
    dv /= largest(base.nodes.v);
    dp /= largest(base.nodes.p);
    std::cout << GetParam().name << ": iterations " << base.report.iterations << " -> " << other.report.iterations
              << ", differences v " << dv << " p " << dp << " sigma " << ds / s << "\n";
    EXPECT_LT(dv, 1e-7);
    EXPECT_LT(dp, 1e-7);
    EXPECT_LT(ds / s, 1e-7);
    EXPECT_NE(base.report.finalP, other.report.finalP) << "the change had no effect at all";
}

INSTANTIATE_TEST_SUITE_P(
    , ConvergedStep,
    testing::Values(Change{"theta", [](Controls& c) { c.momentum.theta = 1; }},
                    Change{"schurScale", [](Controls& c) { c.continuity.schurScale *= 2; }},
                    Change{"complianceScale", [](Controls& c) { c.continuity.complianceScale *= 2; }},
                    Change{"freeSurfaceScale", [](Controls& c) { c.continuity.freeSurfaceScale *= 2; }}),
    [](const auto& test) { return std::string(test.param.name); });

// A column of honey: viscous forces a hundred times those of inertia, on a grid of 50 mm.
TEST(ViscousPressure, takesFewerIterationsToTheSameStep) {
    TestCase c = makeCase("meshSize 0.05; bodies ( honey { type fluid; material honey; " + rectangle(0, 0, 0.4, 0.4) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                          "honey { type newtonian; rho 1000; mu 2000; }", "tank { type noSlip; }");
    c.controls.convergence.maxIterations = 200;
    c.start(1e-3);
    for (int n = 0; n < 5; ++n) c.step(5e-3);
    c.tolerance(1e-8);
    const auto topology = c.topology();
    const auto constraints = c.constraints(topology);
    const auto step = [&](double scale) {
        c.controls.continuity.viscousScale = scale;
        const double gamma = c.controls.timeIntegration.gamma;
        return fsiStep<2>({c.problem, c.state.mesh, topology, constraints, c.state.nodes, {5e-3, gamma}}, c.controls);
    };
    const auto with = step(1), without = step(0);
    EXPECT_LT(with.report.iterations, 0.8 * without.report.iterations);
    std::cout << "iterations " << without.report.iterations << " -> " << with.report.iterations << "\n";
    for (int i = 0; i < c.state.nodes.size(); ++i)
        EXPECT_NEAR(with.nodes.p[i], without.nodes.p[i], 1e-6 * largest(with.nodes.p));
}

}  // namespace
