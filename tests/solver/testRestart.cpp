// A run that is written, read and continued is the run itself, bit for bit; the stress of solid cells included.

#include <gtest/gtest.h>

#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A column of water beside a soft step, released.
TestCase smallFsi(const std::string& integration, const std::string& formulation = "velocity") {
    TestCase c = waterBesideStep();
    c.controls.integration.integration = integration;
    c.controls.solid.formulation = formulation;
    c.start(1e-3);
    return c;
}

class Restart : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Restart, isBitwiseTheRunItself) {
    const TemporaryFolder folder;
    const auto [integration, formulation] = GetParam();
    TestCase c = smallFsi(integration, formulation);
    for (int n = 0; n < 15; ++n) c.step(2e-3);
    writeState(folder.path() / "0.03", c.state);
    TestCase again = c;
    again.state = readState<2>(folder.path() / "0.03");
    const auto before = c.state.mesh.fluid.nodes;
    for (int n = 0; n < 60; ++n) {
        c.step(2e-3);
        again.step(2e-3);
    }
    expectIdentical(c.state, again.state);
    EXPECT_NE(before, c.state.mesh.fluid.nodes) << "the fluid has not been remeshed";
    EXPECT_EQ(c.state.mesh.solid.sigma.empty(), std::string(integration) == "nodal");
}

INSTANTIATE_TEST_SUITE_P(, Restart,
                         testing::Values(std::tuple("nodal", "velocity"), std::tuple("elemental", "velocity"),
                                         std::tuple("elemental", "velocityPressure")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

// What laws remember is in the time folder too: a step of metal and one of rubber with damping, glued together.
TEST_P(Restart, withLawsThatRemember) {
    const auto [integration, formulation] = GetParam();
    const bool nodal = std::string(integration) == "nodal";
    TestCase c = makeCase(
        "meshSize 0.05; bodies ("
        " water { type fluid; material water; vertices ((0 0) (0.4 0) (0.4 0.2) (0.6 0.2) (0.6 0.4) (0 0.4)); }"
        " step { type solid; material metal; vertices ((0.4 0) (0.5 0) (0.5 0.2) (0.4 0.2));"
        "   patches { base { edges ((0 1)); } }  }"
        " pad { type solid; material pad; vertices ((0.5 0) (0.6 0) (0.6 0.2) (0.5 0.2));"
        "   patches { padBase { edges ((0 1)); } } } );"
        " walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
        "water { type newtonian; rho 1000; mu 0.5; kappa 2.1e9; }"
        "metal { type j2FinitePlasticity; rho 1200; E 1e5; nu 0.3; yieldStress 500; hardening 1e4; }"
        "pad { type viscoelastic; rho 1200; E 1e5; nu 0.3; ratios (0.5); times (0.02); }",
        "tank { type slip; } base { type clamped; } padBase { type clamped; }");
    c.controls.integration.integration = integration;
    c.controls.solid.formulation = formulation;
    c.start(1e-3);
    for (int n = 0; n < 15; ++n) c.step(2e-3);
    const TemporaryFolder folder;
    writeState(folder.path() / "0.03", c.state);
    TestCase again = c;
    again.state = readState<2>(folder.path() / "0.03");
    expectIdentical(c.state, again.state);
    for (int n = 0; n < 20; ++n) {
        c.step(2e-3);
        again.step(2e-3);
    }
    expectIdentical(c.state, again.state);
    const History& history = nodal ? c.state.nodes.history : c.state.mesh.solid.history;
    EXPECT_EQ(history.names.size(), 7u + 12u);
    EXPECT_EQ(history.names[0], "plasticStrain");
    double largest = 0;
    for (std::size_t p = 0; p < history.values.size() / history.names.size(); ++p)
        largest = std::max(largest, history.at(static_cast<int>(p), 0));
    EXPECT_GT(largest, 1e-3);  // it has yielded
}

// A state of a nodal run goes on with elements, which start from the mean of their nodes, and back.
TEST(ChangeOfIntegration, goesOnFromTheMeans) {
    TestCase c = smallFsi("nodal");
    for (int n = 0; n < 15; ++n) c.step(2e-3);
    const auto stress = [&] {
        double sum = 0;
        for (const auto& s : c.state.nodes.sigma) sum += s.norm();
        return sum;
    };
    const double nodal = stress();
    c.controls.integration.integration = "elemental";
    c.step(1e-4);
    EXPECT_EQ(static_cast<int>(c.state.mesh.solid.sigma.size()), c.state.mesh.solid.size());
    EXPECT_NEAR(stress(), nodal, 0.3 * nodal);
    EXPECT_GT(stress(), 0.5 * nodal);
    c.controls.integration.integration = "nodal";
    c.step(1e-4);
    EXPECT_TRUE(c.state.mesh.solid.sigma.empty());
    EXPECT_GT(stress(), 0.5 * nodal);
}

}  // namespace
