// The fluid's mass with linear velocities: M_IJ = int rho N_I N_J.

#include "momentum/consistentMass.hpp"

#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

PFEM_BOTH_DIMENSIONS(ConsistentMass);

TYPED_TEST(ConsistentMass, integratesLinearVelocities) {
    constexpr int Dim = TypeParam::value;
    auto c = irregular<Dim>();
    const auto topology = c.topology();
    const auto& nodes = c.state.nodes;
    const auto& cells = c.state.mesh.fluid;
    const FluidPhase<Dim> fluid(c.problem, c.state.mesh, topology.fluid, nodes, Integration::nodal);
    const double rho = c.problem.fluid(0).rho;

    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-1, 1);
    Points<Dim> u(nodes.size()), w(nodes.size());
    for (auto* field : {&u, &w})
        for (auto& v : *field)
            for (int d = 0; d < Dim; ++d) v[d] = value(random);
    Points<Dim> Mu(nodes.size(), Vec<Dim>::Zero()), Mw = Mu, uniform = Mu;
    addMassDifference<Dim>(fluid, 2, u, Mu);
    addMassDifference<Dim>(fluid, 2, w, Mw);
    addMassDifference<Dim>(fluid, 2, Points<Dim>(nodes.size(), Vec<Dim>::Ones()), uniform);

    // int rho u . w of each cell by its midpoints of edges and corners: exact for quadratic functions
    double exact = 0, lumped = 0, difference = 0, symmetric = 0, energy = 0, energyDifference = 0;
    for (const auto& s : cells.nodes) {
        const double mass = rho * simplexMeasure<Dim>(nodes.x, s);
        double corners = 0, edges = 0;
        for (int a = 0; a <= Dim; ++a) {
            corners += u[s[a]].dot(w[s[a]]);
            for (int b = 0; b < a; ++b) edges += (u[s[a]] + u[s[b]]).dot(w[s[a]] + w[s[b]]) / 4;
            energy += mass / (Dim + 1) * u[s[a]].squaredNorm();
        }
        constexpr double ofCorner = Dim == 2 ? 0 : -1.0 / 20, ofEdge = Dim == 2 ? 1.0 / 3 : 1.0 / 5;
        exact += mass * (ofCorner * corners + ofEdge * edges);
        lumped += mass / (Dim + 1) * corners;
        energyDifference += mass / (Dim + 1) * squaredSpeedDifference<Dim>(s, u);
    }
    double ofU = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        difference += 0.5 * Mu[i].dot(w[i]);
        symmetric += 0.5 * Mw[i].dot(u[i]);
        ofU += 0.5 * Mu[i].dot(u[i]);
        EXPECT_LT(uniform[i].norm(), 1e-12 * rho);
    }
    EXPECT_NEAR(lumped + difference, exact, 1e-10 * energy);
    EXPECT_NEAR(difference, symmetric, 1e-10 * energy);
    EXPECT_NEAR(energyDifference, ofU, 1e-10 * energy);
    EXPECT_LT(ofU, -0.1 * energy);  // rough velocities have less inertia
    EXPECT_GT(energy + ofU, 0);     // but some
}

}  // namespace
