// Two pressures at an interface: the fluid's and, of velocity-pressure solids, the solid's.

#include <gtest/gtest.h>

#include "material/hypoelastic.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, nu = 0.4;

/// Water, 0.5 m deep, on a weightless elastic floor between frictionless sides.
TestCase column(const char* integration, const char* formulation) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " patches { sides { edges ((1 2) (3 0)); } } } floor { type solid; material stiff; " +
                              rectangle(0, -0.3, 1, 0) +
                              " patches { base { edges ((0 1)); } sides { edges ((1 2) (3 0)); } } } );",
                          water + "stiff { type hypoelastic; rho 1e-3; E 1e7; nu 0.4; }",
                          "base { type clamped; } sides { type symmetry; }");
    c.controls.integration.integration = integration;
    c.controls.solid.formulation = formulation;
    c.controls.timeIntegration.gamma = 1;  // the floor settles under its load
    c.tolerance(1e-8);
    return c;
}

// The floor cannot widen: sigma_yy = -p, sigma_xx = sigma_zz = -p nu/(1 - nu), so that its pressure is
// p (1 + nu)/(3 (1 - nu)) while the water's is p: 7/9 of it at one and the same node. One shared pressure
// would give one of the two values on both sides.
class InterfacePressure : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(InterfacePressure, isTwofold) {
    const auto [integration, formulation] = GetParam();
    TestCase c = column(integration, formulation);
    c.start(4e-3);
    for (int n = 0; n < 30; ++n) ASSERT_EQ(c.step(4e-3).rejected, 0);
    const auto topology = c.topology();
    const double p = 1000 * g * 0.5;
    int interface = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        if (topology.fluid.count(i) == 0 || topology.solid.count(i) == 0) continue;
        ++interface;
        EXPECT_NEAR(c.state.nodes.p[i], p, 1e-3 * p);
        EXPECT_NEAR(pressure<2>(c.state.nodes.sigma[i]), p * (1 + nu) / (3 * (1 - nu)), 5e-3 * p);
        EXPECT_NEAR(c.state.nodes.sigma[i][1], -p, 5e-3 * p);
    }
    EXPECT_EQ(interface, 11);
}

INSTANTIATE_TEST_SUITE_P(, InterfacePressure,
                         testing::Values(std::tuple("elemental", "velocityPressure"),
                                         std::tuple("elemental", "velocity"), std::tuple("nodal", "velocity")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

}  // namespace
