#pragma once
// The cantilever under a sudden end load: L 25, D 4, E 1e4, nu 1/4, rho 1, end shear 40.

#include "material/neoHookean.hpp"
#include "momentum/mass.hpp"
#include "momentum/solidStress.hpp"
#include "support/cases.hpp"

namespace pfem::test {

/// `cells` = "(nx ny)" of the pattern (checkerboard, oneWay, crossed).
inline TestCase cantilever(const std::string& cells, const std::string& pattern, const std::string& integration,
                           const std::string& update, double damping) {
    TestCase c = makeCase("meshSize 2; bodies ( beam { type solid; material steel; " +
                              rectangle(0, 0, 25, 4) + " pattern " + pattern + "; cells " + cells +
                              "; patches { base { edges ((3 0)); } end { edges ((1 2)); } } } );",
                          "steel { type hypoelastic; rho 1; E 1e4; nu 0.25; }",
                          "base { type clamped; } end { type traction; traction (0 10 0); }", {0, 0});
    c.controls.integration.integration = integration;
    c.controls.solid.stressUpdate = update;
    c.controls.solid.damping = damping;
    c.tolerance(1e-6);
    return c;
}

/// Stored elastic energy sum_p Omega_p sigma : C^-1 : sigma / 2; neoHookean: sum_p Omega_p W(F_p) [J/m].
inline double strainEnergy(const TestCase& c) {
    const auto topology = c.topology();
    const auto& nodes = c.state.nodes;
    const auto& cells = c.state.mesh.solid;
    const bool hyperelastic = c.controls.solid.stressUpdate == "neoHookean";
    const auto patches = makePatches<2>(cells.nodes, topology.solid, hyperelastic ? nodes.X : nodes.x,
                                        c.controls.integration.scheme());
    const auto F = toPoints<2>(patches, elementGradient<2>(patches, nodes.x));
    const auto sigma = storedAtPoints<2>(patches, nodes.sigma, cells.sigma);
    double sum = 0;
    for (int p = 0; p < nStressPoints<2>(patches); ++p) {
        if (!isStressPoint<2>(patches, p)) continue;
        const Hypoelastic& m = solidMaterial<2>(c.problem, cells, patches, p);
        const Stress<2>& s = sigma[p];
        const double trace = s[0] + s[1] + s[2];
        const double squares = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2 * s[3] * s[3];
        const double density = hyperelastic ? neoHookeanEnergy<2>(m, F[p])
                                            : 0.5 / m.E * ((1 + m.nu) * squares - m.nu * trace * trace);
        sum += pointVolume<2>(patches, p) * density;
    }
    return sum;
}

/// sum_I m_I v_I^2 / 2 of the solid [J/m].
inline double kineticEnergy(const TestCase& c) {
    const auto mass = solidMass<2>(c.problem, c.state.mesh.solid, c.state.nodes.X);
    double sum = 0;
    for (std::size_t i = 0; i < mass.size(); ++i) sum += 0.5 * mass[i] * c.state.nodes.v[i].squaredNorm();
    return sum;
}

}  // namespace pfem::test
