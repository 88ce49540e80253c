// The stabilised continuity equation against its terms and against exact states.

#include <gtest/gtest.h>

#include <numeric>

#include "continuity/residual.hpp"
#include "continuity/stabilisation.hpp"
#include "momentum/fluidStress.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double dt = 2e-3;

PFEM_BOTH_DIMENSIONS(ContinuityResidual);
PFEM_BOTH_DIMENSIONS(StabilisationTime);

template <int Dim>
struct Fluid {
    CaseOf<Dim> c;
    Topology<Dim> topology;
    SmoothingDomains<Dim> patches;
    PerCell<double> tau;
    int n;

    explicit Fluid(CaseOf<Dim> testCase)
        : c(std::move(testCase)),
          topology(c.topology()),
          patches(makeSmoothingDomains<Dim>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x)),
          tau(stabilisation<Dim>(c.problem, c.state.mesh.fluid, patches, viscosities(), c.state.nodes.v, dt)),
          n(c.state.nodes.size()) {}

    /// From rest, with the pressures pOld.
    std::vector<double> residual(const Nodes<Dim>& trial, const std::vector<double>& pOld, double divTarget = 0) const {
        Nodes<Dim> old = c.state.nodes;
        old.p = pOld;
        return residual(trial, old, divTarget);
    }
    std::vector<double> residual(const Nodes<Dim>& trial, const Nodes<Dim>& old, double divTarget = 0) const {
        Nodes<Dim> middle = trial;  // in the same place, so that each term is seen alone
        if (c.controls.continuity.stabilisation != "bodyForce")
            for (int i = 0; i < n; ++i) middle.a[i] = (trial.v[i] - old.v[i]) / dt;
        const auto& controls = c.controls.continuity;
        const auto constraints = c.constraints(topology);
        FluidPhase<Dim> fluid(c.problem, c.state.mesh, topology.fluid, old, Integration::nodal);
        fluid.domains = patches;
        const Step<Dim> step{c.problem, c.state.mesh, topology, constraints, old, {dt}, divTarget};
        const auto projected = projectedCells<Dim>(controls, c.problem, c.state.mesh.fluid, topology, old);
        return continuityResidual<Dim>(step, controls, fluid, {tau, projected},
                                       {trial, middle, {}, Vec<Dim>::Zero(), {}});
    }
    PerCell<double> viscosities() const {
        return PerCell<double>(c.state.mesh.fluid.size(),
                               c.problem.materials[c.state.mesh.fluid.material[0]].fluid.law->viscosity(0, 0));
    }
};

/// tau of a surface's face with a cell of height h over it.
double tauN(double tau, double mu, double h, int dim) { return std::min(tau, h * h / (4 * (dim + 1) * mu)); }

TYPED_TEST(ContinuityResidual, derivativeWithRespectToPressure) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f(irregular<Dim>());
    f.c.controls.continuity.stabilisation = "inertia";
    f.c.problem.materials[0].fluid.kappa = f.c.problem.materials[1].fluid.kappa = 1e5;  // make it felt
    Nodes<Dim> trial = f.c.state.nodes;
    trial.v = someVectors<Dim>(f.n, 1);
    trial.a = someVectors<Dim>(f.n, 2);
    trial.p = randomNumbers(f.n, 3);
    const auto pOld = randomNumbers(f.n, 4), q = randomNumbers(f.n, 5);
    const auto R0 = f.residual(trial, pOld);
    for (int i = 0; i < f.n; ++i) trial.p[i] += q[i];
    const auto R1 = f.residual(trial, pOld);

    // tau (L + M_G) q + Omega/(kappa dt) q, from the definitions
    std::vector<double> expected(f.n, 0.0), surface(f.n, 0.0);
    for (int e = 0; e < f.patches.nCells(); ++e) {
        const auto& cell = f.patches.cell(e);
        const auto g = simplexGeometry<Dim>(trial.x, cell);
        for (int k = 0; k <= Dim; ++k) {
            expected[cell[k]] += g.measure / (Dim + 1) / (1e5 * dt) * q[cell[k]];
            for (int l = 0; l <= Dim; ++l)
                expected[cell[k]] += f.tau[e] * g.measure * g.gradN[k].dot(g.gradN[l]) * q[cell[l]];
        }
    }
    for (const auto& face : f.topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double size = faceArea<Dim>(trial.x, face.nodes).norm();
        const double height = Dim * f.patches.element[face.cell].measure / size;
        for (int node : face.nodes)
            surface[node] += tauN(f.tau[face.cell], 3, height, Dim) * 2 / height * size / Dim * q[node];
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
TYPED_TEST(ContinuityResidual, projectionIsSymmetricAndPositive) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f(irregular<Dim>());
    ASSERT_EQ(f.c.controls.continuity.stabilisation, "projection");
    f.c.problem.gravity.setZero();
    for (auto& m : f.c.problem.materials) m.fluid.kappa = 1e300;
    std::mt19937 random(9);
    std::uniform_real_distribution<double> factor(0.5, 2);
    for (double& t : f.tau) t *= factor(random);  // different in each cell
    const auto projected =
        projectedCells<Dim>(f.c.controls.continuity, f.c.problem, f.c.state.mesh.fluid, f.topology, f.c.state.nodes);
    for (int e = 0; e < f.patches.nCells(); ++e)
        if (!projected[e]) f.tau[e] = 0;  // beside the solid and at corners: not of this kind
    EXPECT_GT(std::count(projected.begin(), projected.end(), 1), (Dim == 2 ? 0.7 : 0.3) * f.patches.nCells());
    const auto S = [&](const std::vector<double>& p) {
        Nodes<Dim> trial = f.c.state.nodes;
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
        const Vec<Dim> x = f.c.state.nodes.x[i];
        linear[i] = 3 * x[0] - 2 * x[1] + 4 * x[Dim - 1] + 5;
        quadratic[i] = x[0] * x[0];
    }
    EXPECT_LT(largest(S(linear)), 1e-13 * largestPower);
    EXPECT_GT(dot(quadratic, S(quadratic)), 1e-9 * largestPower);
}

// The force of the pressure and the divergence are adjoint: v . (B^T p) = p . (B v).
TYPED_TEST(ContinuityResidual, divergenceIsAdjointToThePressureForce) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f(irregular<Dim>());
    f.c.problem.gravity.setZero();
    std::fill(f.tau.begin(), f.tau.end(), 0.0);
    for (auto& m : f.c.problem.materials) m.fluid.law = newtonian(0);
    const auto v = someVectors<Dim>(f.n, 1);
    const auto p = randomNumbers(f.n, 2);
    Nodes<Dim> trial = f.c.state.nodes;
    trial.v = v;
    const auto Bv = f.residual(trial, trial.p);
    Points<Dim> force(f.n, Vec<Dim>::Zero());
    addPressureForce<Dim>(f.patches, p, force);
    EXPECT_NEAR(dot(p, Bv), -dot(v, force), 1e-13);
    EXPECT_GT(std::abs(dot(p, Bv)), 0.01);
}

// Omega_I div_I is the rate of the patch's volume.
TYPED_TEST(ContinuityResidual, divergenceIsTheRateOfTheVolume) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f(irregular<Dim>());
    f.c.problem.gravity.setZero();
    std::fill(f.tau.begin(), f.tau.end(), 0.0);
    Nodes<Dim> trial = f.c.state.nodes;
    trial.v = someVectors<Dim>(f.n, 1);
    const auto rate = f.residual(trial, trial.p);
    const double eps = 1e-6;
    auto plus = trial.x, minus = trial.x;
    for (int i = 0; i < f.n; ++i) {
        plus[i] += eps * trial.v[i];
        minus[i] -= eps * trial.v[i];
    }
    const auto a = makeSmoothingDomains<Dim>(f.c.state.mesh.fluid.nodes, f.topology.fluid, plus);
    const auto b = makeSmoothingDomains<Dim>(f.c.state.mesh.fluid.nodes, f.topology.fluid, minus);
    for (int i = 0; i < f.n; ++i) EXPECT_NEAR(rate[i], (a.volume[i] - b.volume[i]) / (2 * eps), 1e-9);
    const auto target = f.residual(trial, trial.p, 0.5);
    for (int i = 0; i < f.n; ++i) EXPECT_NEAR(target[i] - rate[i], -0.5 * f.patches.volume[i], 1e-15);
}

/// Water in a tub of rubber, its level at 0.5 m.
template <int Dim>
CaseOf<Dim> waterInATub() {
    if constexpr (Dim == 2) {
        return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                            " } tub { type solid; material rubber; vertices ((-0.2 -0.2) (1.2 -0.2) (1.2 0.5) (1 0.5)"
                            " (1 0) (0 0) (0 0.5) (-0.2 0.5)); } );",
                        water + rubber, "");
    } else {
        const auto isIn = [](const Vec<3>& x) { return x.minCoeff() > 0 && x[0] < 0.6 && x[1] < 0.4; };
        return onLattice({-0.2, -0.2, -0.2}, {0.8, 0.6, 0.5}, 0.1, isIn, std::not_fn(isIn), water + rubber);
    }
}

// The tank of an elastic solid accelerates: grad p = rho (g - a) is exact with the interface's acceleration.
TYPED_TEST(ContinuityResidual, exactStatesHaveNone) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f(waterInATub<Dim>());
    EXPECT_EQ(std::count_if(f.topology.faces.begin(), f.topology.faces.end(),
                            [](const auto& face) { return face.kind == FaceKind::interface; }),
              Dim == 2 ? 20 : 248);
    const double scale = f.tau[0] * 1000 * 9.81;
    for (const char* stabilisation : {"projection", "inertia", "bodyForce"})
        for (const double a : {0.0, 4.0, -9.81}) {  // at rest, pushed up, falling
            auto& controls = f.c.controls.continuity;
            controls.stabilisation = stabilisation;
            Nodes<Dim> trial = f.c.state.nodes;
            for (int i = 0; i < f.n; ++i) {
                trial.a[i] = a * Vec<Dim>::Unit(Dim - 1);
                trial.v[i] = a * dt * Vec<Dim>::Unit(Dim - 1);
                trial.p[i] = 1000 * (9.81 + a) * (0.5 - trial.x[i][Dim - 1]);
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
TYPED_TEST(ContinuityResidual, freeSurfaceStates) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f(freeBlock<Dim>("syrup { type newtonian; rho 1000; mu 50; }"));
    for (const char* stabilisation : {"inertia", "bodyForce"}) {
        f.c.controls.continuity.stabilisation = stabilisation;
        const Vec<Dim> g = -9.81 * Vec<Dim>::Unit(Dim - 1);
        Nodes<Dim> old = f.c.state.nodes, trial = old;
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
        EXPECT_LT(largest(f.residual(trial, old, 0.3 * Dim)), 1e-13) << stabilisation;
        std::fill(trial.p.begin(), trial.p.end(), 0.0);
        EXPECT_GT(largest(f.residual(trial, trial, 0.3 * Dim)), 1e-6) << stabilisation;
    }
}

/// One cell of a thick fluid deep.
template <int Dim>
CaseOf<Dim> layer() {
    const std::string syrup = "syrup { type newtonian; rho 1000; mu 3000; }";
    if constexpr (Dim == 2) {
        return makeCase(
            "meshSize 0.1; bodies ( water { type fluid; material syrup; " + rectangle(0, 0, 1, 0.1) + " } );", syrup,
            "", Vec<2>::Zero());
    } else {
        TestCase3 c = onLattice(
            Vec<3>::Zero(), {0.6, 0.4, 0.1}, 0.1, [](const Vec<3>&) { return true; },
            [](const Vec<3>&) { return false; }, syrup);
        c.problem.gravity.setZero();
        return c;
    }
}

// However flat the cells of a thick fluid are, where it swells across its surface the residual is a swelling, or
// nothing in cells that are alone around a node.
TYPED_TEST(ContinuityResidual, theSurfaceDoesNotOutweighTheDivergence) {
    constexpr int Dim = TypeParam::value;
    CaseOf<Dim> film = layer<Dim>();
    for (auto& x : film.state.nodes.x) x[Dim - 1] *= 0.2;
    Fluid<Dim> f(film);
    Nodes<Dim> trial = f.c.state.nodes;
    for (int i = 0; i < f.n; ++i) trial.v[i] = trial.x[i][Dim - 1] * Vec<Dim>::Unit(Dim - 1);
    const auto R = f.residual(trial, trial);
    for (int i = 0; i < f.n; ++i) EXPECT_GT(R[i], -1e-12 * f.patches.volume[i]) << i;
}

TYPED_TEST(StabilisationTime, formula) {
    constexpr int Dim = TypeParam::value;
    Fluid<Dim> f(irregular<Dim>());
    std::fill(f.c.state.nodes.v.begin(), f.c.state.nodes.v.end(),
              Vec<Dim>(3 * Vec<Dim>::UnitX() + 4 * Vec<Dim>::UnitY()));
    const auto tau =
        stabilisation<Dim>(f.c.problem, f.c.state.mesh.fluid, f.patches, f.viscosities(), f.c.state.nodes.v, dt);
    for (int e = 0; e < f.patches.nCells(); ++e) {
        const double h2 = std::pow((Dim == 2 ? 2 : 6) * f.patches.element[e].measure, 2.0 / Dim);
        EXPECT_NEAR(1 / tau[e], 8 * 3 / h2 + 1000 / dt + 1000 * 5 / std::sqrt(h2), 1e-6);
        EXPECT_NEAR(1 / f.tau[e], 8 * 3 / h2 + 1000 / dt, 1e-6);  // at rest not switched off
    }
    for (const double height : {0.01, 0.1, 1.0})
        EXPECT_NEAR(surfaceStabilisation<Dim>(2e-4, 3, 0.1 * height / Dim, 0.1), tauN(2e-4, 3, height, Dim), 1e-18)
            << height;
}

}  // namespace
