// The solid's forces on a mesh: matrix against finite differences, damper, rotations.

#include <gtest/gtest.h>

#include "functions/storedEnergy.hpp"
#include "momentum/mass.hpp"
#include "momentum/pointMotion.hpp"
#include "momentum/solidElementStress.hpp"
#include "momentum/solidMatrix.hpp"
#include "momentum/surfaceStiffness.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

PFEM_BOTH_DIMENSIONS(SolidTangent);
PFEM_BOTH_DIMENSIONS(Damper);
PFEM_BOTH_DIMENSIONS(StressOfSolids);
PFEM_BOTH_DIMENSIONS(VelocityPressure);
PFEM_BOTH_DIMENSIONS(NeoHookeanForce);
PFEM_BOTH_DIMENSIONS(SolidMass);

template <int Dim>
struct SolidCase {
    CaseOf<Dim> c = irregular<Dim>();
    Topology<Dim> topology = c.topology();
    NodeConstraints<Dim> constraints = c.constraints(topology);
    int n = c.state.nodes.size();
    const Cells<Dim>& cells = c.state.mesh.solid;

    Integration scheme = Integration::nodal;

    SmoothingDomains<Dim> patches(const Points<Dim>& x) const {
        return makeSmoothingDomains<Dim>(cells.nodes, topology.solid, x, scheme);
    }

    SmoothingDomains<Dim> gradientPatches(const Nodes<Dim>& old, const Nodes<Dim>& t) const {
        auto at = patches(t.x);
        updateGradientDomains<Dim>(c.problem, cells, old, t, at);
        return at;
    }

    /// Positions at the end of the step and the stress there.
    struct Trial {
        Nodes<Dim> nodes;
        SolidStress<Dim> stress;
    };
    Trial trial(const SolidControls& controls, const Nodes<Dim>& old, const Points<Dim>& v, double dt) const {
        Nodes<Dim> t = old;
        t.v = v;
        for (int i = 0; i < n; ++i) t.x[i] = MidpointRule{dt}.template position<Dim>(old.x[i], old.v[i], v[i]);
        return stressOf(controls, old, t, dt);
    }
    Trial stressOf(const SolidControls& controls, const Nodes<Dim>& old, const Nodes<Dim>& t, double dt) const {
        const auto gradients = gradientPatches(old, t);
        return {t, solidStress<Dim>({c.problem, controls, cells}, gradients, old, t, dt)};
    }
    Points<Dim> force(const SolidControls& controls, const Nodes<Dim>& old, const Trial& t) const {
        Points<Dim> f(n, Vec<Dim>::Zero());
        const auto gradients = gradientPatches(old, t.nodes), end = patches(t.nodes.x);
        addInternalForce<Dim>(
            end, solidElementStress<Dim>({c.problem, controls, cells}, gradients, end, t.stress, t.nodes), f);
        return f;
    }
    /// Force of the damper alone: no stress.
    Points<Dim> dampingForce(const SolidControls& controls, const Nodes<Dim>& nodes) const {
        const PerPoint<Stress<Dim>> zero(nStressPoints<Dim>(patches(nodes.x)), Stress<Dim>::Zero());
        return force(controls, nodes, {nodes, {zero, {}, {}}});
    }
    bool carries(int p) const { return isStressPoint<Dim>(patches(c.state.nodes.x), p); }
};

template <int Dim>
Eigen::VectorXd gather(const SolidDofs<Dim>& dofs, const Points<Dim>& u) {
    Eigen::VectorXd r(dofs.n);
    for (std::size_t k = 0; k < dofs.node.size(); ++k)
        for (int i = 0; i < dofs.count[dofs.node[k]]; ++i)
            r[dofs.first[dofs.node[k]] + i] = dofs.basis[k].col(i).dot(u[dofs.node[k]]);
    return r;
}

struct TangentCase {
    std::string update;
    double damping, gamma;
    Integration scheme;
    std::string formulation;
};

/// All updates, with and without damper, both time schemes and integrations.
std::vector<TangentCase> tangentCases() {
    std::vector<TangentCase> all;
    for (const char* formulation : {"velocity", "velocityPressure"})
        for (const char* update : {"rotatedMidpoint", "paper", "neoHookean"})
            for (const double damping : {0.0, 0.1})
                for (const double gamma : {0.5, 1.0})
                    for (const Integration scheme : {Integration::nodal, Integration::elemental})
                        if (gamma == 0.5 || formulation == std::string("velocity"))
                            all.push_back({update, damping, gamma, scheme, formulation});
    return all;
}

// A_s = d(residual)/dv at small strain.
TYPED_TEST(SolidTangent, isTheDerivativeOfTheResidual) {
    constexpr int Dim = TypeParam::value;
    for (const auto& [update, damping, gamma, scheme, formulation] : tangentCases()) {
        SCOPED_TRACE(update + " " + formulation + ", damping " + std::to_string(damping));
        SolidCase<Dim> s;
        s.scheme = scheme;
        SolidControls controls;
        useUpdate<Dim>(s.c.problem, update);
        controls.damping = damping;
        controls.formulation = formulation;
        const MidpointRule midpoint{Dim == 2 ? 2e-3 : 1e-2, gamma};
        const auto mass = solidMass<Dim>(s.c.problem, s.cells, s.c.state.nodes.X);
        const auto& old = s.c.state.nodes;
        const auto dofs = solidDofs<Dim>(s.topology.solid, s.constraints);
        const auto A =
            solidMatrix<Dim>({s.c.problem, controls, s.cells}, s.patches(old.x), dofs,
                             matrixInertia<Dim>(mass, Points<Dim>(s.n, Vec<Dim>::Zero()), midpoint), old.h, midpoint);

        Points<Dim> w = someVectors<Dim>(s.n, 5);
        for (int i = 0; i < s.n; ++i) w[i] = s.constraints.project(i, w[i]);
        const double eps = 1e-4;
        const auto residual = [&](double factor) {
            Points<Dim> v = w;
            for (auto& u : v) u *= factor;
            Points<Dim> R = s.force(controls, old, s.trial(controls, old, v, midpoint.dt));
            for (int i = 0; i < s.n; ++i)
                R[i] += mass[i] * midpoint.template acceleration<Dim>(old.v[i], v[i]) / midpoint.gamma;
            return gather<Dim>(dofs, R);
        };
        const Eigen::VectorXd difference = (residual(eps) - residual(-eps)) / (2 * eps);
        const Eigen::VectorXd exact = A.multiply(gather<Dim>(dofs, w));
        EXPECT_LT((difference - exact).norm(), 1e-7 * exact.norm());
        // the stiffness is a visible part of it
        Eigen::VectorXd inertia = exact;
        for (std::size_t k = 0; k < dofs.node.size(); ++k)
            for (int i = 0; i < dofs.count[dofs.node[k]]; ++i)
                inertia[dofs.first[dofs.node[k]] + i] =
                    midpoint.massFactor() * mass[dofs.node[k]] * dofs.basis[k].col(i).dot(w[dofs.node[k]]);
        EXPECT_GT((exact - inertia).norm(), 1e-2 * exact.norm());
    }
}

TYPED_TEST(Damper, vanishesForLinearFieldsAndDissipatesTheRest) {
    constexpr int Dim = TypeParam::value;
    SolidCase<Dim> s;
    SolidControls controls;
    controls.damping = 0.1;
    Nodes<Dim> nodes = s.c.state.nodes;
    const Tensor<Dim> L = someGradient<Dim>();
    for (int i = 0; i < s.n; ++i) nodes.v[i] = L * nodes.x[i];
    EXPECT_LT(largest(s.dampingForce(controls, nodes)), 1e-9);
    for (unsigned seed = 1; seed < 6; ++seed) {
        s.scheme = Integration::nodal;
        nodes.v = someVectors<Dim>(s.n, seed);
        EXPECT_GT(dot(nodes.v, s.dampingForce(controls, nodes)), 1.0);
        s.scheme = Integration::elemental;  // no zig-zag modes, no damper
        EXPECT_EQ(largest(s.dampingForce(controls, nodes)), 0.0);
    }
}

TEST(DampingTime, isThatOfAWaveThroughACell) {
    EXPECT_NEAR(dampingTime(Solid{1500, {2e5, 0.3}, nullptr}, 0.1, 0.02), 0.1 * 0.02 * std::sqrt(1500 / 2e5), 1e-15);
}

// A block that turns rigidly, node by node, by 360 degrees: its stress turns with it.
TYPED_TEST(StressOfSolids, stressedBlockTurnsBy360Degrees) {
    constexpr int Dim = TypeParam::value;
    for (const Integration scheme : {Integration::nodal, Integration::elemental})
        for (const auto& [stressed, formulation] :
             {std::pair(true, "velocity"), std::pair(false, "velocity"), std::pair(true, "velocityPressure")}) {
            SolidCase<Dim> s;
            s.scheme = scheme;
            SolidControls controls;
            controls.formulation = formulation;
            Nodes<Dim> nodes = s.c.state.nodes;
            Stress<Dim> sigma0 = Stress<Dim>::Constant(-7e2);
            sigma0.template head<4>() << 3e3, -1e3, 5e2, 2e3;
            if (!stressed) sigma0.setZero();
            for (int i = 0; i < s.n; ++i)
                if (s.topology.onSolid[i]) nodes.sigma[i] = sigma0;
            const int steps = 60;
            const double dt = 0.01, scale = stressed ? sigma0.norm() : 2e5;
            for (int k = 0; k < steps; ++k) {
                Nodes<Dim> next = nodes;
                const Tensor<Dim> R = turn<Dim>(2 * M_PI * (k + 1) / steps);
                const Vec<Dim> pivot = Vec<Dim>::LinSpaced(1, 2);
                for (int i = 0; i < s.n; ++i) {
                    next.x[i] = pivot + R * (nodes.X[i] - pivot);
                    nodes.v[i] = next.v[i] = (next.x[i] - nodes.x[i]) / dt;
                }
                auto stress = s.stressOf(controls, nodes, next, dt).stress;
                storeSolidStress<Dim>(s.patches(next.x), std::move(stress), next.sigma, s.c.state.mesh.solid.sigma);
                nodes = next;
            }
            EXPECT_EQ(s.cells.sigma.empty(), scheme == Integration::nodal);
            for (const auto& sigma : s.cells.sigma) EXPECT_LT((sigma - sigma0).norm(), 1e-9 * scale);
            for (int i = 0; i < s.n; ++i)
                if (s.topology.onSolid[i]) {
                    EXPECT_LT((nodes.sigma[i] - sigma0).norm(), 1e-9 * scale);
                }
        }
}

// Uniaxial strain of the whole mesh: M = E (1-nu)/((1+nu)(1-2nu)) in every stress point, interface included.
TYPED_TEST(StressOfSolids, uniaxialStrain) {
    constexpr int Dim = TypeParam::value;
    const double E = 2e5, nu = 0.3, M = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), dt = 1e-3, strain = 1e-6;
    for (const Integration scheme : {Integration::nodal, Integration::elemental})
        for (const char* update : {"rotatedMidpoint", "paper", "neoHookean"}) {
            SolidCase<Dim> s;
            s.scheme = scheme;
            SolidControls controls;
            useUpdate<Dim>(s.c.problem, update);
            Points<Dim> v(s.n);
            for (int i = 0; i < s.n; ++i) v[i] = strain / dt * s.c.state.nodes.x[i][1] * Vec<Dim>::UnitY();
            Nodes<Dim> old = s.c.state.nodes;
            old.v = v;  // steady: the displacement of the step is dt v
            const auto t = s.trial(controls, old, v, dt);
            ASSERT_EQ(static_cast<int>(t.stress.point.size()), scheme == Integration::nodal ? s.n : s.cells.size());
            for (int p = 0; p < static_cast<int>(t.stress.point.size()); ++p)
                if (s.carries(p)) {
                    EXPECT_NEAR(t.stress.point[p][1], M * strain, 1e-5 * M * strain);
                    EXPECT_NEAR(t.stress.point[p][0], M * strain * nu / (1 - nu), 1e-5 * M * strain);
                    for (int k = 3; k < nStress<Dim>; ++k) EXPECT_NEAR(t.stress.point[p][k], 0, 1e-5 * M * strain);
                }
        }
}

// Nodal pressure with nodal deviators is the nodal method itself; with elemental ones it is neither of the two.
TYPED_TEST(VelocityPressure, nodalIsTheNodalMethod) {
    constexpr int Dim = TypeParam::value;
    SolidCase<Dim> s;
    SolidControls velocity, mixed;
    mixed.formulation = "velocityPressure";
    const auto v = someVectors<Dim>(s.n, 8);
    const auto force = [&](const SolidControls& controls, Integration scheme) {
        s.scheme = scheme;
        return s.force(controls, s.c.state.nodes, s.trial(controls, s.c.state.nodes, v, 1e-3));
    };
    const auto difference = [](Points<Dim> a, const Points<Dim>& b) {
        for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
        return largest(a) / largest(b);
    };
    const auto nodal = force(velocity, Integration::nodal), elemental = force(velocity, Integration::elemental);
    EXPECT_LT(difference(force(mixed, Integration::nodal), nodal), 1e-13);
    EXPECT_GT(difference(force(mixed, Integration::elemental), nodal), 0.1);
    EXPECT_GT(difference(force(mixed, Integration::elemental), elemental), 0.1);
}

// neoHookean: the force is the derivative of the energy function, at large strain too: sum_p Omega_p W(F_p), and with a
// nodal pressure sum_p Omega_p W_mu(F_p) + sum_I Omega_I0 U(Omega_I/Omega_I0).
TYPED_TEST(NeoHookeanForce, forceIsTheDerivativeOfTheEnergy) {
    constexpr int Dim = TypeParam::value;
    for (const char* formulation : {"velocity", "velocityPressure"})
        for (const char* integration : {"nodal", "elemental"}) {
            SolidCase<Dim> s;
            Controls all;
            all.integration.integration = integration;
            SolidControls& controls = all.solid;
            s.scheme = all.integration.scheme();
            useUpdate<Dim>(s.c.problem, "neoHookean");
            controls.formulation = formulation;
            controls.damping = 0;
            const Nodes<Dim>& old = s.c.state.nodes;
            const auto energy = [&](const Points<Dim>& x) {
                State<Dim> state = s.c.state;
                state.nodes.x = x;
                return elasticEnergy<Dim>(s.c.problem, all, state);
            };
            Nodes<Dim> t = old;
            const auto shift = someVectors<Dim>(s.n, 3), w = someVectors<Dim>(s.n, 9);
            const Tensor<Dim> F = corner<Dim>({1.2, -0.6, 0.2, 0.5, 1.1, -0.3, 0.1, 0.25, 0.9});
            for (int i = 0; i < s.n; ++i) t.x[i] = F * old.X[i] + 0.012 * shift[i];
            const auto f = s.force(controls, old, s.stressOf(controls, old, t, 1e-3));
            const double eps = 1e-6;
            Points<Dim> plus = t.x, minus = t.x;
            for (int i = 0; i < s.n; ++i) {
                plus[i] += eps * w[i];
                minus[i] -= eps * w[i];
            }
            const double slope = (energy(plus) - energy(minus)) / (2 * eps);
            EXPECT_GT(std::abs(slope), 1e3);
            EXPECT_NEAR(dot(f, w), slope, 1e-6 * std::abs(slope));
        }
}

TYPED_TEST(SolidMass, isThatOfTheReferencePositions) {
    constexpr int Dim = TypeParam::value;
    SolidCase<Dim> s;
    const auto mass = solidMass<Dim>(s.c.problem, s.cells, s.c.state.nodes.X);
    const auto patches = s.patches(s.c.state.nodes.X);
    for (int i = 0; i < s.n; ++i) EXPECT_NEAR(mass[i], 1500 * patches.volume[i], 1e-10);
}

}  // namespace
