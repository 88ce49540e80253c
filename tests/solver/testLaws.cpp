// Laws of solids in whole cases: of two kinds side by side, and against closed forms.

#include <gtest/gtest.h>

#include "functions/storedEnergy.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

const std::string metal = "metal { type j2Plasticity; rho 2000; E 1e6; nu 0.3; yieldStress 4e3; hardening 1e4; }";
const std::string gum = "gum { type neoHookean; rho 1000; E 1e6; nu 0.4; }";

/// Beams of 1 m, fixed on the left, falling under their weight. `left` and `right` name their materials; empty: no
/// beam.
TestCase beams(const std::string& left, const std::string& right, const std::string& integration,
               const std::string& formulation) {
    const auto beam = [](const std::string& name, double x) {
        return name + " { type solid; material " + name + "; " + rectangle(x, 0, x + 1, 0.2) +
               " pattern checkerboard; cells (10 2); patches { " + name + "Base { edges ((3 0)); } } } ";
    };
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( " + (left.empty() ? "" : beam(left, 0)) + (right.empty() ? "" : beam(right, 3)) + " );",
        metal + gum, "\".*Base\" { type clamped; }");
    c.controls.integration.integration = integration;
    c.controls.solid.formulation = formulation;
    c.tolerance(1e-9);
    return c;
}

// A plastic and a hyperelastic beam in one case move as each of them alone.
TEST(Laws, twoKindsInOneCase) {
    for (const auto& [integration, formulation] : {std::pair("nodal", "velocity"), std::pair("elemental", "velocity"),
                                                   std::pair("elemental", "velocityPressure")}) {
        TestCase both = beams("metal", "gum", integration, formulation);
        TestCase left = beams("metal", "", integration, formulation),
                 right = beams("", "gum", integration, formulation);
        for (int n = 0; n < 30; ++n)
            for (TestCase* c : {&both, &left, &right}) EXPECT_EQ(c->step(5e-3).rejected, 0);
        const auto tip = [](const TestCase& c, double x) {
            const int i = nearestNode(c.state.nodes.X, {x, 0});
            return Vec<2>(c.state.nodes.x[i] - c.state.nodes.X[i]);
        };
        EXPECT_LT((tip(both, 1) - tip(left, 1)).norm(), 1e-6) << integration << " " << formulation;
        EXPECT_LT((tip(both, 4) - tip(right, 4)).norm(), 1e-6) << integration << " " << formulation;
        EXPECT_GT(tip(both, 1).norm(), 0.05);
        EXPECT_GT(tip(both, 4).norm(), 0.02);
        double plastic = 0;
        const History& history =
            std::string(integration) == "nodal" ? both.state.nodes.history : both.state.mesh.solid.history;
        for (const double value : history.values) plastic = std::max(plastic, value);
        EXPECT_GT(plastic, 1e-3);  // the metal has yielded
        const double energies = elasticEnergy<2>(left.problem, left.controls, left.state) +
                                elasticEnergy<2>(right.problem, right.controls, right.state);
        EXPECT_NEAR(elasticEnergy<2>(both.problem, both.controls, both.state), energies, 1e-5 * energies);
    }
}

/// A quarter of a tube, radii 1 and 2, under a pressure that grows slowly.
struct Tube {
    static constexpr int n = 20;  // pieces of the arcs
    static constexpr double E = 210, nu = 0.3, yieldStress = 0.24;
    TestCase c;
    std::vector<Vec<2>> normal;  // of the inner pieces

    explicit Tube(const std::string& type, const std::string& integration, const std::string& formulation) {
        std::string vertices, patches;
        const auto add = [&](double r, double angle) {
            vertices += "(" + std::to_string(r * std::cos(angle)) + " " + std::to_string(r * std::sin(angle)) + ") ";
        };
        for (int k = 0; k <= n; ++k) add(1, 0.5 * M_PI * (n - k) / n);
        for (int k = 0; k <= n; ++k) add(2, 0.5 * M_PI * k / n);
        std::string conditions = "low { type symmetry; } left { type symmetry; }";
        for (int k = 0; k < n; ++k) {
            const std::string name = "inner" + std::to_string(k);
            patches += name + " { edges ((" + std::to_string(k) + " " + std::to_string(k + 1) + ")); } ";
            conditions += name + " { type traction; traction (0 0 0); }";
        }
        patches += "low { edges ((" + std::to_string(n) + " " + std::to_string(n + 1) + ")); } left { edges ((" +
                   std::to_string(2 * n + 1) + " 0)); } ";
        c = makeCase("meshSize 0.08; bodies ( tube { type solid; material tube; vertices (" + vertices +
                         "); patches { " + patches + "} } );",
                     "tube { type " + type + "; rho 1e-9; E 210; nu 0.3; yieldStress 0.24; }", conditions, {0, 0});
        c.controls.integration.integration = integration;
        c.controls.solid = {formulation, 0};
        c.controls.timeIntegration.gamma = 1;
        c.tolerance(1e-7, 3000);
    }
    /// Outer radius' growth under a pressure, in `steps` from the present one.
    double growth(double from, double to, int steps) {
        for (int s = 1; s <= steps; ++s) {
            const double p = from + (to - from) * s / steps;
            for (std::size_t k = 0; k < c.state.mesh.patches.size(); ++k) {
                if (c.state.mesh.patches[k].name.rfind("inner", 0) != 0) continue;
                const Face<2>& face = c.state.mesh.patches[k].faces[0];
                const Vec<2> middle = 0.5 * (c.state.nodes.X[face[0]] + c.state.nodes.X[face[1]]);
                c.problem.conditions.traction[k] = p * middle.normalized();
            }
            for (auto& v : c.state.nodes.v) v.setZero();
            c.step(1);
        }
        const int i = nearestNode(c.state.nodes.X, {std::sqrt(2.0), std::sqrt(2.0)});
        return c.state.nodes.x[i].norm() - c.state.nodes.X[i].norm();
    }
};

// Hill: plastic up to the radius r, p = Y (ln(r/a) + (1 - r^2/b^2)/2) with Y = 2 sigma_y/sqrt(3), and the outer radius
// grows by Y r^2 (1 - nu^2)/(E b).
TEST(Laws, tubeUnderPressure) {
    const double Y = 2 * Tube::yieldStress / std::sqrt(3.0);
    for (const auto& [type, integration, formulation] :
         {std::tuple("j2Plasticity", "nodal", "velocity"), std::tuple("j2Plasticity", "elemental", "velocityPressure"),
          std::tuple("j2FinitePlasticity", "elemental", "velocityPressure")}) {
        Tube tube(type, integration, formulation);
        double last = 0;
        for (const auto& [r, steps] : {std::pair(1.0, 1), std::pair(1.3, 4), std::pair(1.6, 6)}) {
            const double p = Y * (std::log(r) + 0.5 * (1 - r * r / 4));
            const double exact = Y * r * r * (1 - Tube::nu * Tube::nu) / (Tube::E * 2);
            const double found = tube.growth(last, p, steps);
            std::cout << type << " " << integration << " " << formulation << ": plastic to " << r << ", p " << p
                      << ": growth " << found << ", exact " << exact << "\n";
            EXPECT_NEAR(found, exact, 0.02 * exact);
            last = p;
        }
    }
}

/// Cook's membrane of metal under the whole load of 5 in steps: rise of the upper right corner.
double cooksCorner(int n, const std::string& integration, const std::string& formulation) {
    const std::string cells = "(" + std::to_string(n) + " " + std::to_string(n) + ")";
    TestCase c = makeCase(
        "meshSize 5; bodies ( membrane { type solid; material metal; vertices ((0 0) (48 44) (48 60) (0 44)); pattern "
        "oneWay; cells " +
            cells + "; patches { base { edges ((3 0)); } end { edges ((1 2)); } } } );",
        "metal { type j2FinitePlasticity; rho 1e-9; E 206.9; nu 0.29; yieldStress 0.45; hardening 0.12924; "
        "saturationStress 0.715; saturationRate 16.93; }",
        "base { type clamped; } end { type traction; traction (0 1 0); }", {0, 0});
    c.controls.integration.integration = integration;
    c.controls.solid = {formulation, 0};
    c.controls.timeIntegration.gamma = 1;
    c.tolerance(1e-6, 5000);
    const Points<2> X = c.state.nodes.X;
    const int steps = 20;
    for (int s = 1; s <= steps; ++s) {
        for (std::size_t k = 0; k < c.state.mesh.patches.size(); ++k) {
            double now = 0;
            for (const auto& face : c.state.mesh.patches[k].faces) now += faceArea<2>(c.state.nodes.x, face).norm();
            if (c.state.mesh.patches[k].name == "end") c.problem.conditions.traction[k] = {0, 5.0 * s / steps / now};
        }
        for (auto& v : c.state.nodes.v) v.setZero();
        c.step(1);
    }
    const int corner = nearestNode(X, {48, 60});
    const double rise = c.state.nodes.x[corner][1] - X[corner][1];
    std::cout << "Cook's membrane of metal, " << integration << " " << formulation << ", " << n << ": " << rise << "\n";
    return rise;
}

// Published for fine meshes: 6.97 ... 7.09 (Simo and Armero 1992; Cesar de Sa, Areias and Natal Jorge 2001; Areias).
// Nodal stress is near with 16 cells a side; the mixed elements come from below (doc/decisions.md).
TEST(Laws, cooksMembraneOfMetal) {
    constexpr double published = 7.0;
    EXPECT_NEAR(cooksCorner(16, "nodal", "velocity"), published, 0.02 * published);
    const double coarse = cooksCorner(8, "elemental", "velocityPressure");
    const double fine = cooksCorner(16, "elemental", "velocityPressure");
    EXPECT_GT(coarse, 0.5 * published);
    EXPECT_LT(published - fine, 0.5 * (published - coarse));
    EXPECT_LT(fine, published);
}

// Standing waves along a bar of rubber with a quick branch: the energy falls as exp(-k^2 4 eta t/(3 rho)), eta = beta
// tau mu.
TEST(Laws, viscoelasticBarSwingsOut) {
    TestCase c =
        makeCase("meshSize 0.05; bodies ( bar { type solid; material bar; " + rectangle(0, 0, 1, 0.1) +
                     " pattern checkerboard; cells (20 2); patches { all { edges ((0 1) (1 2) (2 3) (3 0)); } } } );",
                 "bar { type viscoelastic; rho 1000; E 1e6; nu 0.3; ratios (20); times (1e-4); }",
                 "all { type symmetry; }", {0, 0});
    c.controls.integration.integration = "elemental";
    c.tolerance(1e-8);
    for (int i = 0; i < c.state.nodes.size(); ++i)
        c.state.nodes.v[i] = {1e-3 * std::sin(M_PI * c.state.nodes.x[i][0]), 0};
    const auto energy = [&] { return storedEnergy<2>(c.problem, c.controls, c.state).total(); };
    const double before = energy(), dt = 1e-3;
    for (int n = 0; n < 150; ++n) c.step(dt);
    const double eta = 20 * 1e-4 * 1e6 / 2.6, rate = M_PI * M_PI * 4 * eta / (3 * 1000);
    std::cout << "viscoelastic bar: energy left " << energy() / before << ", exact " << std::exp(-rate * 0.15) << "\n";
    EXPECT_NEAR(std::log(energy() / before), -rate * 0.15, 0.03 * rate * 0.15);
}

}  // namespace
