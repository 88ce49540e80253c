// The stabilised continuity equation against its terms and against exact states.

#include <gtest/gtest.h>

#include <numeric>

#include "continuity/residual.hpp"
#include "continuity/stabilisation.hpp"
#include "momentum/fluidStress.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double dt = 2e-3;

struct Fluid {
    TestCase c;
    Topology<2> topology;
    SmoothingDomains<2> patches;
    PerCell<double> tau;
    int n;

    explicit Fluid(TestCase testCase)
        : c(std::move(testCase)),
          topology(c.topology()),
          patches(makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x)),
          tau(stabilisation<2>(c.problem, c.state.mesh.fluid, patches, viscosities(), c.state.nodes.v, dt)),
          n(c.state.nodes.size()) {}

    /// From rest, with the pressures pOld.
    std::vector<double> residual(const Nodes<2>& trial, const std::vector<double>& pOld, double divTarget = 0) const {
        Nodes<2> old = c.state.nodes;
        old.p = pOld;
        return residual(trial, old, divTarget);
    }
    std::vector<double> residual(const Nodes<2>& trial, const Nodes<2>& old, double divTarget = 0) const {
        Nodes<2> middle = trial;  // in the same place, so that each term is seen alone
        if (c.controls.continuity.stabilisation != "bodyForce")
            for (int i = 0; i < n; ++i) middle.a[i] = (trial.v[i] - old.v[i]) / dt;
        const auto& controls = c.controls.continuity;
        const auto constraints = c.constraints(topology);
        FluidPhase<2> fluid(c.problem, c.state.mesh, topology.fluid, old, Integration::nodal);
        fluid.domains = patches;
        const Step<2> step{c.problem, c.state.mesh, topology, constraints, old, {dt}, divTarget};
        const auto projected = projectedCells<2>(controls, c.problem, c.state.mesh.fluid, topology, old);
        return continuityResidual<2>(step, controls, fluid, {tau, projected}, {trial, middle, {}, Vec<2>::Zero()});
    }
    PerCell<double> viscosities() const {
        return PerCell<double>(c.state.mesh.fluid.size(),
                               c.problem.materials[c.state.mesh.fluid.material[0]].fluid.law->viscosity(0, 0));
    }
};

/// tau of a surface's face with a cell of height h over it.
double tauN(double tau, double mu, double h) { return std::min(tau, h * h / (12 * mu)); }

TEST(ContinuityResidual, derivativeWithRespectToPressure) {
    Fluid f(irregularPair());
    f.c.controls.continuity.stabilisation = "inertia";
    f.c.problem.materials[0].fluid.kappa = f.c.problem.materials[1].fluid.kappa = 1e5;  // make it felt
    Nodes<2> trial = f.c.state.nodes;
    trial.v = randomVectors(f.n, 1);
    trial.a = randomVectors(f.n, 2);
    trial.p = randomNumbers(f.n, 3);
    const auto pOld = randomNumbers(f.n, 4), q = randomNumbers(f.n, 5);
    const auto R0 = f.residual(trial, pOld);
    for (int i = 0; i < f.n; ++i) trial.p[i] += q[i];
    const auto R1 = f.residual(trial, pOld);

    // tau (L + M_G) q + Omega/(kappa dt) q, from the definitions
    std::vector<double> expected(f.n, 0.0), surface(f.n, 0.0);
    for (int e = 0; e < f.patches.nCells(); ++e) {
        const auto& cell = f.patches.cell(e);
        const auto g = simplexGeometry<2>(trial.x, cell);
        for (int k = 0; k < 3; ++k) {
            expected[cell[k]] += g.measure / 3 / (1e5 * dt) * q[cell[k]];
            for (int l = 0; l < 3; ++l)
                expected[cell[k]] += f.tau[e] * g.measure * g.gradN[k].dot(g.gradN[l]) * q[cell[l]];
        }
    }
    for (const auto& face : f.topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double length = (trial.x[face.nodes[1]] - trial.x[face.nodes[0]]).norm();
        const double height = 2 * f.patches.element[face.cell].measure / length;
        for (int node : face.nodes)
            surface[node] += tauN(f.tau[face.cell], 3, height) * 2 / height * length / 2 * q[node];
    }
    double part = 0;
    for (int i = 0; i < f.n; ++i) {
        EXPECT_NEAR(R1[i] - R0[i], expected[i] + surface[i], 1e-14) << i;
        part = std::max(part, std::abs(surface[i]));
    }
    EXPECT_GT(part, 1e-7);
}

// The projected stabilisation cannot give energy to any flow: symmetric, q . S q >= 0, nothing for a linear pressure,
// and no volume in the sum.
TEST(ContinuityResidual, projectionIsSymmetricAndPositive) {
    Fluid f(irregularPair());
    ASSERT_EQ(f.c.controls.continuity.stabilisation, "projection");
    f.c.problem.gravity.setZero();
    for (auto& m : f.c.problem.materials) m.fluid.kappa = 1e300;
    std::mt19937 random(9);
    std::uniform_real_distribution<double> factor(0.5, 2);
    for (double& t : f.tau) t *= factor(random);  // different in each cell
    const auto projected =
        projectedCells<2>(f.c.controls.continuity, f.c.problem, f.c.state.mesh.fluid, f.topology, f.c.state.nodes);
    for (int e = 0; e < f.patches.nCells(); ++e)
        if (!projected[e]) f.tau[e] = 0;  // beside the solid and at corners: not of this kind
    EXPECT_GT(std::count(projected.begin(), projected.end(), 1), 0.7 * f.patches.nCells());
    const auto S = [&](const std::vector<double>& p) {
        Nodes<2> trial = f.c.state.nodes;
        trial.p = p;
        return f.residual(trial, f.c.state.nodes);
    };
    double largestPower = 0;
    for (unsigned k = 0; k < 20; ++k) {
        const auto p = randomNumbers(f.n, k), q = randomNumbers(f.n, 100 + k);
        const auto Sp = S(p);
        EXPECT_NEAR(dot(q, Sp), dot(p, S(q)), 1e-12 * std::abs(dot(p, Sp)));
        EXPECT_GT(dot(p, Sp), 0);
        EXPECT_NEAR(std::accumulate(Sp.begin(), Sp.end(), 0.0), 0, 1e-12 * largest(Sp));
        largestPower = std::max(largestPower, dot(p, Sp));
    }
    std::vector<double> linear(f.n), quadratic(f.n);
    for (int i = 0; i < f.n; ++i) {
        const Vec<2> x = f.c.state.nodes.x[i];
        linear[i] = 3 * x[0] - 2 * x[1] + 5;
        quadratic[i] = x[0] * x[0];
    }
    EXPECT_LT(largest(S(linear)), 1e-13 * largestPower);
    EXPECT_GT(dot(quadratic, S(quadratic)), 1e-9 * largestPower);
}

// The force of the pressure and the divergence are adjoint: v . (B^T p) = p . (B v).
TEST(ContinuityResidual, divergenceIsAdjointToThePressureForce) {
    Fluid f(irregularPair());
    f.c.problem.gravity.setZero();
    std::fill(f.tau.begin(), f.tau.end(), 0.0);
    for (auto& m : f.c.problem.materials) m.fluid.law = newtonian(0);
    const auto v = randomVectors(f.n, 1);
    const auto p = randomNumbers(f.n, 2);
    Nodes<2> trial = f.c.state.nodes;
    trial.v = v;
    const auto Bv = f.residual(trial, trial.p);
    Points<2> force(f.n, Vec<2>::Zero());
    addPressureForce<2>(f.patches, p, force);
    EXPECT_NEAR(dot(p, Bv), -dot(v, force), 1e-13);
    EXPECT_GT(std::abs(dot(p, Bv)), 0.01);
}

// Omega_I div_I is the rate of the patch's volume.
TEST(ContinuityResidual, divergenceIsTheRateOfTheVolume) {
    Fluid f(irregularPair());
    f.c.problem.gravity.setZero();
    std::fill(f.tau.begin(), f.tau.end(), 0.0);
    Nodes<2> trial = f.c.state.nodes;
    trial.v = randomVectors(f.n, 1);
    const auto rate = f.residual(trial, trial.p);
    const double eps = 1e-6;
    auto plus = trial.x, minus = trial.x;
    for (int i = 0; i < f.n; ++i) {
        plus[i] += eps * trial.v[i];
        minus[i] -= eps * trial.v[i];
    }
    const auto a = makeSmoothingDomains<2>(f.c.state.mesh.fluid.nodes, f.topology.fluid, plus);
    const auto b = makeSmoothingDomains<2>(f.c.state.mesh.fluid.nodes, f.topology.fluid, minus);
    for (int i = 0; i < f.n; ++i) EXPECT_NEAR(rate[i], (a.volume[i] - b.volume[i]) / (2 * eps), 1e-9);
    const auto target = f.residual(trial, trial.p, 0.5);
    for (int i = 0; i < f.n; ++i) EXPECT_NEAR(target[i] - rate[i], -0.5 * f.patches.volume[i], 1e-15);
}

// The tank of an elastic solid accelerates: grad p = rho (g - a) is exact with the interface's acceleration.
TEST(ContinuityResidual, exactStatesHaveNone) {
    Fluid f(makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                         " } tub { type solid; material rubber; vertices ((-0.2 -0.2) (1.2 -0.2) (1.2 0.5) (1 0.5)"
                         " (1 0) (0 0) (0 0.5) (-0.2 0.5)); } );",
                     water + rubber, ""));
    EXPECT_EQ(std::count_if(f.topology.faces.begin(), f.topology.faces.end(),
                            [](const auto& face) { return face.kind == FaceKind::interface; }),
              20);
    const double scale = f.tau[0] * 1000 * 9.81;
    for (const char* stabilisation : {"projection", "inertia", "bodyForce"})
        for (const double a : {0.0, 4.0, -9.81}) {  // at rest, pushed up, falling
            auto& controls = f.c.controls.continuity;
            controls.stabilisation = stabilisation;
            Nodes<2> trial = f.c.state.nodes;
            for (int i = 0; i < f.n; ++i) {
                trial.a[i] = Vec<2>(0, a);
                trial.v[i] = Vec<2>(0, a * dt);
                trial.p[i] = 1000 * (9.81 + a) * (0.5 - trial.x[i][1]);
            }
            EXPECT_LT(largest(f.residual(trial, trial.p)), 1e-12 * scale) << stabilisation << " " << a;
            controls.interfaceAcceleration = false;
            if (a != 0 && controls.stabilisation == "bodyForce") {
                EXPECT_GT(largest(f.residual(trial, trial.p)), 1e-3 * scale) << a;
            }
            controls.interfaceAcceleration = true;
        }
}

// A free block of a viscous fluid, so that tau differs from cell to cell, that falls or dilates.
TEST(ContinuityResidual, freeSurfaceStates) {
    Fluid f(makeCase("meshSize 0.1; bodies ( water { type fluid; material syrup; " + rectangle(0, 0, 1, 0.5) + " } );",
                     "syrup { type newtonian; rho 1000; mu 50; }", ""));
    for (const char* stabilisation : {"inertia", "bodyForce"}) {
        f.c.controls.continuity.stabilisation = stabilisation;
        const Vec<2> g(0, -9.81);
        Nodes<2> old = f.c.state.nodes, trial = old;
        for (int i = 0; i < f.n; ++i) {
            trial.a[i] = g;
            trial.v[i] = dt * g;
        }
        EXPECT_LT(largest(f.residual(trial, old)), 1e-15) << stabilisation;
        // uniform dilation rate: the weak condition asks for p = 2 mu d_n
        for (int i = 0; i < f.n; ++i) {
            old.v[i] = 0.3 * trial.x[i];
            trial.v[i] = old.v[i] + dt * g;
        }
        std::fill(trial.p.begin(), trial.p.end(), 2 * 50 * 0.3);
        old.p = trial.p;
        EXPECT_LT(largest(f.residual(trial, old, 0.6)), 1e-13) << stabilisation;
        std::fill(trial.p.begin(), trial.p.end(), 0.0);
        EXPECT_GT(largest(f.residual(trial, trial, 0.6)), 1e-6) << stabilisation;
    }
}

// However flat the cells of a thick fluid are, where it swells across its surface the residual is a swelling, or
// nothing in cells that are alone around a node.
TEST(ContinuityResidual, theSurfaceDoesNotOutweighTheDivergence) {
    TestCase film =
        makeCase("meshSize 0.1; bodies ( water { type fluid; material syrup; " + rectangle(0, 0, 1, 0.1) + " } );",
                 "syrup { type newtonian; rho 1000; mu 3000; }", "", Vec<2>::Zero());
    for (auto& x : film.state.nodes.x) x[1] *= 0.2;
    Fluid f(film);
    Nodes<2> trial = f.c.state.nodes;
    for (int i = 0; i < f.n; ++i) trial.v[i] = Vec<2>(0, trial.x[i][1]);
    const auto R = f.residual(trial, trial);
    for (int i = 0; i < f.n; ++i) EXPECT_GT(R[i], -1e-12 * f.patches.volume[i]) << i;
}

TEST(Stabilisation, formula) {
    Fluid f(irregularPair());
    std::fill(f.c.state.nodes.v.begin(), f.c.state.nodes.v.end(), Vec<2>(3, 4));
    const auto tau =
        stabilisation<2>(f.c.problem, f.c.state.mesh.fluid, f.patches, f.viscosities(), f.c.state.nodes.v, dt);
    for (int e = 0; e < f.patches.nCells(); ++e) {
        const double h2 = 2 * f.patches.element[e].measure;
        EXPECT_NEAR(1 / tau[e], 8 * 3 / h2 + 1000 / dt + 1000 * 5 / std::sqrt(h2), 1e-6);
        EXPECT_NEAR(1 / f.tau[e], 8 * 3 / h2 + 1000 / dt, 1e-6);  // at rest not switched off
    }
    for (const double height : {0.01, 0.1, 1.0})
        EXPECT_NEAR(surfaceStabilisation<2>(2e-4, 3, 0.1 * height / 2, 0.1), tauN(2e-4, 3, height), 1e-18) << height;
}

}  // namespace
