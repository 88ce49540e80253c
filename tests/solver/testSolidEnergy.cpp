// Energy of a swinging cantilever: what the zig-zag damper is for.

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>

#include "momentum/residual.hpp"
#include "support/cantilever.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Kinetic plus strain energy less the work of the constant end load, in parts of the largest strain energy. Zero
/// without dissipation and error of the time integration.
struct Balance {
    double largest = 0, smallest = 0;
    double early = 0, late = 0;  // means over the second and the last tenth of the time
};

Balance balance(const std::string& cells, const std::string& pattern, double dt, double endTime,
                const std::string& integration, const std::string& update, double damping,
                const std::string& formulation = "velocity") {
    TestCase c = cantilever(cells, pattern, integration, update, damping);
    c.controls.solid.formulation = formulation;
    c.start(dt);
    const auto traction = tractionForce<2>(c.state.mesh, c.problem.conditions, c.state.nodes.X);
    const double force = std::accumulate(traction.begin(), traction.end(), 0.0,
                                         [](double sum, const Vec<2>& f) { return sum + f.norm(); });
    EXPECT_NEAR(force, 40, 1e-9);
    std::vector<double> energy;
    double highest = 0, work = 0;
    while (c.state.time.value < endTime - 0.5 * dt) {
        const Points<2> x = c.state.nodes.x;
        const auto before = tractionForce<2>(c.state.mesh, c.problem.conditions, x);
        EXPECT_EQ(c.step(dt).rejected, 0);
        const auto after = tractionForce<2>(c.state.mesh, c.problem.conditions, c.state.nodes.x);
        for (std::size_t i = 0; i < x.size(); ++i) work += 0.5 * (before[i] + after[i]).dot(c.state.nodes.x[i] - x[i]);
        const double strain = strainEnergy(c);
        highest = std::max(highest, strain);
        energy.push_back(kineticEnergy(c) + strain - work);
    }
    Balance b;
    for (double& e : energy) {
        e /= highest;
        b.largest = std::max(b.largest, e);
        b.smallest = std::min(b.smallest, e);
    }
    const std::size_t tenth = energy.size() / 10;
    for (std::size_t k = 0; k < tenth; ++k) {
        b.early += energy[tenth + k] / tenth;
        b.late += energy[energy.size() - 1 - k] / tenth;
    }
    std::cout << integration << " " << update << " " << formulation << " damping " << damping << " " << pattern << " "
              << cells << ", " << endTime << " s: energy error min " << b.smallest << " max " << b.largest << " early "
              << b.early << " late " << b.late << " of the peak strain energy " << highest << "\n";
    return b;
}

bool longTests() { return std::getenv("PFEM_LONG_TESTS") != nullptr; }

/// 20 s with h = 1; with PFEM_LONG_TESTS 40 s with h = 0.5.
Balance oneWayMesh(double damping) {
    return longTests() ? balance("(50 8)", "oneWay", 0.01, 40, "nodal", "rotatedMidpoint", damping)
                       : balance("(25 4)", "oneWay", 0.02, 20, "nodal", "rotatedMidpoint", damping);
}

TEST(SolidEnergy, damperHoldsTheEnergy) {
    const Balance b = oneWayMesh(0.1);
    EXPECT_LT(b.largest, 5e-3);
    EXPECT_GT(b.smallest, -5e-3);
    EXPECT_LT(b.late, b.early);  // decaying
}

TEST(SolidEnergy, growsWithoutDamper) {
    const Balance b = oneWayMesh(0);
    EXPECT_GT(b.late, longTests() ? 2e-2 : 2e-3);
    EXPECT_LT(std::abs(b.early), 5e-4);
}

// Elements have no zig-zag modes: neither growth nor dissipation; and the hyperelastic law has a true energy.
TEST(SolidEnergy, elementsNeedNoDamper) {
    for (const auto& [update, formulation] :
         {std::pair("rotatedMidpoint", "velocity"), std::pair("neoHookean", "velocity"),
          std::pair("neoHookean", "velocityPressure")}) {
        const Balance b = balance("(25 4)", "oneWay", 0.02, 20, "elemental", update, 0.1, formulation);
        EXPECT_LT(b.largest, 2e-3);
        EXPECT_GT(b.smallest, -2e-3);
        EXPECT_NEAR(b.late, b.early, 1e-3);
    }
}

}  // namespace
