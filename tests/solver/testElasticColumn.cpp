// A water column on an elastic column between slip walls: exact added mass, closed form.
//
// 0.05 m wide, solid 0 - 0.25 m clamped at its base, water 0.25 - 1 m; released from rest, the solid unstrained.
// Rod with an end mass: beta tan beta = rho_s h_s / (rho_f h_f).

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TestCase column(double rhoS, double E, const std::string& law = "hypoelastic") {
    return makeCase(
        "meshSize 0.0125; bodies ("
        " solid { type solid; material solid; " +
            rectangle(0, 0, 0.05, 0.25) +
            " patches { base { edges ((0 1)); } sides { edges ((1 2) (3 0)); } } }"
            " water { type fluid; material water; " +
            rectangle(0, 0.25, 0.05, 1) + " patches { sides { edges ((1 2) (3 0)); } } } );",
        "water { type newtonian; rho 1000; mu 0; kappa 2.1e9; }"
        "solid { type " +
            law + "; rho " + std::to_string(rhoS) + "; E " + std::to_string(E) + "; nu 0.4; }",
        "base { type clamped; } sides { type symmetry; }", {0, -10});
}

/// With the factors of the matrix that belong to it.
void useStabilisation(TestCase& c, const std::string& name) {
    c.controls.continuity.stabilisation = name;
    if (name == "inertia") return;
    c.controls.continuity.schurScale = 1;
    c.controls.continuity.freeSurfaceScale = 4;
    c.controls.continuity.complianceScale = 3;
}

int interfaceNode(const TestCase& c) { return nearestNode(c.state.nodes.X, {0.025, 0.25}); }

TEST(ElasticColumn, consistentStart) {
    // unstrained solid: everything falls but what the base carries; the pressure is small at first
    TestCase c = column(1500, 2.3e5);
    c.start(1e-3);
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        if (!topology.wet(i)) continue;
        EXPECT_LT(std::abs(c.state.nodes.p[i]), 1500.0);
        if (c.state.nodes.x[i][1] > 0.5) {
            EXPECT_NEAR(c.state.nodes.a[i][1], -10, 0.5) << c.state.nodes.x[i].transpose();
        }
    }
}

// Stress from positions has their round-off times the stiffness: no tolerance of the start is finer than that.
TEST(ElasticColumn, startsWithMetalThatIsHyperelastic) {
    TestCase rates = column(2700, 67.5e9), rubberlike = column(2700, 67.5e9, "neoHookean");
    rates.start(1e-3);
    rubberlike.start(1e-3);
    for (int i = 0; i < rates.state.nodes.size(); ++i) {
        EXPECT_NEAR(rates.state.nodes.p[i], rubberlike.state.nodes.p[i], 1e-3 * 1000 * 10 * 0.75);
        EXPECT_LT((rates.state.nodes.a[i] - rubberlike.state.nodes.a[i]).norm(), 0.01);
    }
}

/// `integration`: of fluid and solid, or "nodalElemental".
void useIntegration(TestCase& c, const std::string& integration) {
    const bool mixed = integration == "nodalElemental";
    c.controls.integration.integration = mixed ? "nodal" : integration;
    if (mixed) c.controls.solid.integration = "elemental";
}

class ElasticColumnOscillates : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(ElasticColumnOscillates, periodAndPeak) {
    const auto [stabilisation, integration] = GetParam();
    TestCase c = column(1500, 2.3e5);
    useStabilisation(c, stabilisation);
    useIntegration(c, integration);
    c.controls.continuity.volumeCorrectionTime = 0;
    const double dt = 1e-3;
    c.start(dt);
    const Id id = c.state.nodes.id[interfaceNode(c)];
    std::vector<double> t, u;
    int most = 0, sum = 0;
    for (int n = 0; n < 400; ++n) {
        const auto report = c.step(dt);
        ASSERT_EQ(report.rejected, 0);
        most = std::max(most, report.step.iterations);
        sum += report.step.iterations;
        const int node = nodeOf(c.state.nodes, id);
        t.push_back(c.state.time.value);
        u.push_back(c.state.nodes.x[node][1] - c.state.nodes.X[node][1]);
    }
    const auto fit = fitHarmonic(t, u, 35, 60);
    const double period = 2 * M_PI / fit.omega, lowest = *std::min_element(u.begin(), u.end());
    std::cout << "period " << period << " s (0.13265), peak " << lowest << " m (-9.51e-3), mean " << fit.mean
              << " (-4.7554e-3), last peak " << *std::min_element(u.end() - 140, u.end()) << ", iterations mean "
              << sum / 400.0 << " max " << most << ", volume change " << c.ledgerSum() / (0.05 * 0.75) << "\n";
    EXPECT_NEAR(period, 0.13265, 0.02 * 0.13265);
    EXPECT_NEAR(lowest, -9.51e-3, 0.03 * 9.51e-3);
    EXPECT_NEAR(*std::min_element(u.end() - 140, u.end()), lowest, 5e-3 * std::abs(lowest));  // no damping
    EXPECT_LE(most, 12);
}

INSTANTIATE_TEST_SUITE_P(, ElasticColumnOscillates,
                         testing::Values(std::tuple("inertia", "nodal"), std::tuple("bodyForce", "nodal"),
                                         std::tuple("inertia", "elemental"), std::tuple("inertia", "nodalElemental")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

struct ColumnCase {
    double rhoS, E;
    const char* integration = "nodal";
    const char* formulation = "velocity";
};
std::ostream& operator<<(std::ostream& out, const ColumnCase& c) {
    return out << "rho_s " << c.rhoS << ", E " << c.E << ", " << c.integration << ", " << c.formulation;
}

class ElasticColumnConverges : public testing::TestWithParam<ColumnCase> {};

TEST_P(ElasticColumnConverges, inTwelveIterations) {
    TestCase c = column(GetParam().rhoS, GetParam().E);
    useIntegration(c, GetParam().integration);
    c.controls.solid.formulation = GetParam().formulation;
    c.start(1e-3);
    int most = 0, sum = 0;
    for (int n = 0; n < 50; ++n) {
        const auto report = c.step(1e-3);
        ASSERT_EQ(report.rejected, 0) << report.reasons.front();
        most = std::max(most, report.step.iterations);
        sum += report.step.iterations;
    }
    std::cout << "rho_s " << GetParam().rhoS << " E " << GetParam().E << " iterations mean " << sum / 50.0 << " max "
              << most << "\n";
    EXPECT_LE(most, 12);
}

INSTANTIATE_TEST_SUITE_P(materials, ElasticColumnConverges,
                         testing::Values(ColumnCase{1500, 2.3e4}, ColumnCase{1500, 2.3e5}, ColumnCase{1500, 2.3e7},
                                         ColumnCase{1500, 2.3e9}, ColumnCase{150, 2.3e4}, ColumnCase{150, 2.3e5},
                                         ColumnCase{150, 2.3e7}, ColumnCase{150, 2.3e9}, ColumnCase{15, 2.3e4},
                                         ColumnCase{15, 2.3e5}, ColumnCase{15, 2.3e7}, ColumnCase{15, 2.3e9},
                                         ColumnCase{1500, 2.3e5, "elemental"}, ColumnCase{15, 2.3e5, "elemental"},
                                         ColumnCase{150, 2.3e7, "elemental"}, ColumnCase{15, 2.3e9, "elemental"},
                                         ColumnCase{1500, 2.3e5, "elemental", "velocityPressure"},
                                         ColumnCase{15, 2.3e5, "elemental", "velocityPressure"},
                                         ColumnCase{15, 2.3e5, "nodalElemental", "velocityPressure"}),
                         [](const auto& test) {
                             const int power = static_cast<int>(std::log10(test.param.E));
                             return "rho" + std::to_string(static_cast<int>(test.param.rhoS)) + "_E1e" +
                                    std::to_string(power) + "_" + test.param.integration + "_" + test.param.formulation;
                         });

}  // namespace
