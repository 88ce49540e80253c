#pragma once
// The cantilever under a sudden end load: L 25, D 4, E 1e4, nu 1/4, rho 1, end shear 40.

#include "functions/storedEnergy.hpp"
#include "momentum/mass.hpp"
#include "support/cases.hpp"

namespace pfem::test {

/// `cells` = "(nx ny)" of the pattern (checkerboard, oneWay, crossed).
inline TestCase cantilever(const std::string& cells, const std::string& pattern, const std::string& integration,
                           const std::string& update, double damping) {
    TestCase c =
        makeCase("meshSize 2; bodies ( beam { type solid; material steel; " + rectangle(0, 0, 25, 4) + " pattern " +
                     pattern + "; cells " + cells + "; patches { base { edges ((3 0)); } end { edges ((1 2)); } } } );",
                 "steel { type hypoelastic; rho 1; E 1e4; nu 0.25; }",
                 "base { type clamped; } end { type traction; traction (0 10 0); }", {0, 0});
    c.controls.integration.integration = integration;
    useUpdate(c.problem, update);
    c.controls.solid.damping = damping;
    c.tolerance(1e-6);
    return c;
}

/// Stored elastic energy [J/m].
inline double strainEnergy(const TestCase& c) { return elasticEnergy<2>(c.problem, c.controls, c.state); }

/// sum_I m_I v_I^2 / 2 of the solid [J/m].
inline double kineticEnergy(const TestCase& c) {
    const auto mass = solidMass<2>(c.problem, c.state.mesh.solid, c.state.nodes.X);
    double sum = 0;
    for (std::size_t i = 0; i < mass.size(); ++i) sum += 0.5 * mass[i] * c.state.nodes.v[i].squaredNorm();
    return sum;
}

}  // namespace pfem::test
