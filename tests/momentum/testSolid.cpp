// The solid's forces on a mesh: matrix against finite differences, damper, rotations.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "functions/storedEnergy.hpp"
#include "momentum/mass.hpp"
#include "momentum/solidMatrix.hpp"
#include "momentum/solidStress.hpp"
#include "momentum/surfaceStiffness.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

struct SolidCase {
    TestCase c = irregularPair();
    Topology<2> topology = c.topology();
    NodeConstraints<2> constraints = c.constraints(topology);
    int n = c.state.nodes.size();
    const Cells<2>& cells = c.state.mesh.solid;

    Integration scheme = Integration::nodal;

    SmoothingDomains<2> patches(const Points<2>& x) const {
        return makeSmoothingDomains<2>(cells.nodes, topology.solid, x, scheme);
    }

    SmoothingDomains<2> gradientPatches(const Nodes<2>& old, const Nodes<2>& t) const {
        auto at = patches(t.x);
        updateGradientDomains<2>(c.problem, cells, old, t, at);
        return at;
    }

    /// Positions at the end of the step and the stress there.
    struct Trial {
        Nodes<2> nodes;
        SolidStress<2> stress;
    };
    Trial trial(const SolidControls& controls, const Nodes<2>& old, const Points<2>& v, double dt) const {
        Nodes<2> t = old;
        t.v = v;
        for (int i = 0; i < n; ++i) t.x[i] = MidpointRule{dt}.position<2>(old.x[i], old.v[i], v[i]);
        return stressOf(controls, old, t, dt);
    }
    Trial stressOf(const SolidControls& controls, const Nodes<2>& old, const Nodes<2>& t, double dt) const {
        const auto gradients = gradientPatches(old, t);
        return {t, solidStress<2>({c.problem, controls, cells}, gradients, old, t, dt)};
    }
    Points<2> force(const SolidControls& controls, const Nodes<2>& old, const Trial& t) const {
        Points<2> f(n, Vec<2>::Zero());
        const auto gradients = gradientPatches(old, t.nodes), end = patches(t.nodes.x);
        addInternalForce<2>(end, solidElementStress<2>({c.problem, controls, cells}, gradients, end, t.stress, t.nodes),
                            f);
        return f;
    }
    /// Force of the damper alone: no stress.
    Points<2> dampingForce(const SolidControls& controls, const Nodes<2>& nodes) const {
        const PerPoint<Stress<2>> zero(nStressPoints<2>(patches(nodes.x)), Stress<2>::Zero());
        return force(controls, nodes, {nodes, {zero, {}, {}}});
    }
    bool carries(int p) const { return isStressPoint<2>(patches(c.state.nodes.x), p); }
};

Eigen::VectorXd gather(const SolidDofs<2>& dofs, const Points<2>& u) {
    Eigen::VectorXd r(dofs.n);
    for (std::size_t k = 0; k < dofs.node.size(); ++k)
        for (int i = 0; i < dofs.count[dofs.node[k]]; ++i)
            r[dofs.first[dofs.node[k]] + i] = dofs.basis[k].col(i).dot(u[dofs.node[k]]);
    return r;
}

class SolidTangent : public testing::TestWithParam<std::tuple<const char*, double, double, Integration, const char*>> {
};

// A_s = d(residual)/dv at small strain, for all updates, with and without damper, both time schemes and integrations.
TEST_P(SolidTangent, isTheDerivativeOfTheResidual) {
    SolidCase s;
    s.scheme = std::get<3>(GetParam());
    SolidControls controls;
    useUpdate(s.c.problem, std::get<0>(GetParam()));
    controls.damping = std::get<1>(GetParam());
    controls.formulation = std::get<4>(GetParam());
    const MidpointRule midpoint{2e-3, std::get<2>(GetParam())};
    const auto mass = solidMass<2>(s.c.problem, s.cells, s.c.state.nodes.X);
    const auto& old = s.c.state.nodes;
    const auto dofs = solidDofs<2>(s.topology.solid, s.constraints);
    const auto A = solidMatrix<2>({s.c.problem, controls, s.cells}, s.patches(old.x), dofs,
                                  matrixInertia<2>(mass, Points<2>(s.n, Vec<2>::Zero()), midpoint), old.h, midpoint);

    Points<2> w = randomVectors(s.n, 5);
    for (int i = 0; i < s.n; ++i) w[i] = s.constraints.project(i, w[i]);
    const double eps = 1e-4;
    const auto residual = [&](double factor) {
        Points<2> v = w;
        for (auto& u : v) u *= factor;
        Points<2> R = s.force(controls, old, s.trial(controls, old, v, midpoint.dt));
        for (int i = 0; i < s.n; ++i) R[i] += mass[i] * midpoint.acceleration<2>(old.v[i], v[i]) / midpoint.gamma;
        return gather(dofs, R);
    };
    const Eigen::VectorXd difference = (residual(eps) - residual(-eps)) / (2 * eps);
    const Eigen::VectorXd exact = A.multiply(gather(dofs, w));
    EXPECT_LT((difference - exact).norm(), 1e-7 * exact.norm());
    // the stiffness is a visible part of it
    Eigen::VectorXd inertia = exact;
    for (std::size_t k = 0; k < dofs.node.size(); ++k)
        for (int i = 0; i < dofs.count[dofs.node[k]]; ++i)
            inertia[dofs.first[dofs.node[k]] + i] =
                midpoint.massFactor() * mass[dofs.node[k]] * dofs.basis[k].col(i).dot(w[dofs.node[k]]);
    EXPECT_GT((exact - inertia).norm(), 1e-2 * exact.norm());
}

INSTANTIATE_TEST_SUITE_P(updates, SolidTangent,
                         testing::Combine(testing::Values("rotatedMidpoint", "paper", "neoHookean"),
                                          testing::Values(0.0, 0.1), testing::Values(0.5, 1.0),
                                          testing::Values(Integration::nodal, Integration::elemental),
                                          testing::Values("velocity")));
INSTANTIATE_TEST_SUITE_P(velocityPressure, SolidTangent,
                         testing::Combine(testing::Values("rotatedMidpoint", "paper", "neoHookean"),
                                          testing::Values(0.0, 0.1), testing::Values(0.5),
                                          testing::Values(Integration::nodal, Integration::elemental),
                                          testing::Values("velocityPressure")));

TEST(Damper, vanishesForLinearFieldsAndDissipatesTheRest) {
    SolidCase s;
    SolidControls controls;
    controls.damping = 0.1;
    Nodes<2> nodes = s.c.state.nodes;
    Tensor<2> L;
    L << 0.3, -1, 0.7, 0.2;
    for (int i = 0; i < s.n; ++i) nodes.v[i] = L * nodes.x[i];
    EXPECT_LT(largest(s.dampingForce(controls, nodes)), 1e-9);
    for (unsigned seed = 1; seed < 6; ++seed) {
        s.scheme = Integration::nodal;
        nodes.v = randomVectors(s.n, seed);
        EXPECT_GT(dot(nodes.v, s.dampingForce(controls, nodes)), 1.0);
        s.scheme = Integration::elemental;  // no zig-zag modes, no damper
        EXPECT_EQ(largest(s.dampingForce(controls, nodes)), 0.0);
    }
}

TEST(Damper, timeScale) {
    EXPECT_NEAR(dampingTime(Solid{1500, {2e5, 0.3}, nullptr}, 0.1, 0.02), 0.1 * 0.02 * std::sqrt(1500 / 2e5), 1e-15);
}

// A block that turns rigidly, node by node, by 360 degrees: its stress turns with it.
TEST(SolidStress, stressedBlockTurnsBy360Degrees) {
    for (const Integration scheme : {Integration::nodal, Integration::elemental})
        for (const auto& [stressed, formulation] :
             {std::pair(true, "velocity"), std::pair(false, "velocity"), std::pair(true, "velocityPressure")}) {
            SolidCase s;
            s.scheme = scheme;
            SolidControls controls;
            controls.formulation = formulation;
            Nodes<2> nodes = s.c.state.nodes;
            Stress<2> sigma0;
            sigma0 << 3e3, -1e3, 5e2, 2e3;
            if (!stressed) sigma0.setZero();
            for (int i = 0; i < s.n; ++i)
                if (s.topology.onSolid[i]) nodes.sigma[i] = sigma0;
            const int steps = 60;
            const double dt = 0.01, scale = stressed ? sigma0.norm() : 2e5;
            for (int k = 0; k < steps; ++k) {
                Nodes<2> next = nodes;
                const Tensor<2> R = Eigen::Rotation2Dd(2 * M_PI * (k + 1) / steps).toRotationMatrix();
                for (int i = 0; i < s.n; ++i) {
                    next.x[i] = Vec<2>(1, 2) + R * (nodes.X[i] - Vec<2>(1, 2));
                    nodes.v[i] = next.v[i] = (next.x[i] - nodes.x[i]) / dt;
                }
                auto stress = s.stressOf(controls, nodes, next, dt).stress;
                storeSolidStress<2>(s.patches(next.x), std::move(stress), next.sigma, s.c.state.mesh.solid.sigma);
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
TEST(SolidStress, uniaxialStrain) {
    const double E = 2e5, nu = 0.3, M = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), dt = 1e-3, strain = 1e-6;
    for (const Integration scheme : {Integration::nodal, Integration::elemental})
        for (const char* update : {"rotatedMidpoint", "paper", "neoHookean"}) {
            SolidCase s;
            s.scheme = scheme;
            SolidControls controls;
            useUpdate(s.c.problem, update);
            Points<2> v(s.n);
            for (int i = 0; i < s.n; ++i) v[i] = Vec<2>(0, strain / dt * s.c.state.nodes.x[i][1]);
            Nodes<2> old = s.c.state.nodes;
            old.v = v;  // steady: the displacement of the step is dt v
            const auto t = s.trial(controls, old, v, dt);
            ASSERT_EQ(static_cast<int>(t.stress.point.size()), scheme == Integration::nodal ? s.n : s.cells.size());
            for (int p = 0; p < static_cast<int>(t.stress.point.size()); ++p)
                if (s.carries(p)) {
                    EXPECT_NEAR(t.stress.point[p][1], M * strain, 1e-5 * M * strain);
                    EXPECT_NEAR(t.stress.point[p][0], M * strain * nu / (1 - nu), 1e-5 * M * strain);
                    EXPECT_NEAR(t.stress.point[p][3], 0, 1e-5 * M * strain);
                }
        }
}

// Nodal pressure with nodal deviators is the nodal method itself; with elemental ones it is neither of the two.
TEST(VelocityPressure, nodalIsTheNodalMethod) {
    SolidCase s;
    SolidControls velocity, mixed;
    mixed.formulation = "velocityPressure";
    const auto v = randomVectors(s.n, 8);
    const auto force = [&](const SolidControls& controls, Integration scheme) {
        s.scheme = scheme;
        return s.force(controls, s.c.state.nodes, s.trial(controls, s.c.state.nodes, v, 1e-3));
    };
    const auto difference = [](Points<2> a, const Points<2>& b) {
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
TEST(NeoHookean, forceIsTheDerivativeOfTheEnergy) {
    for (const char* formulation : {"velocity", "velocityPressure"})
        for (const char* integration : {"nodal", "elemental"}) {
            SolidCase s;
            Controls all;
            all.integration.integration = integration;
            SolidControls& controls = all.solid;
            s.scheme = all.integration.scheme();
            useUpdate(s.c.problem, "neoHookean");
            controls.formulation = formulation;
            controls.damping = 0;
            const Nodes<2>& old = s.c.state.nodes;
            const auto energy = [&](const Points<2>& x) {
                State<2> state = s.c.state;
                state.nodes.x = x;
                return elasticEnergy<2>(s.c.problem, all, state);
            };
            Nodes<2> t = old;
            const auto shift = randomVectors(s.n, 3), w = randomVectors(s.n, 9);
            Tensor<2> F;
            F << 1.2, -0.6, 0.5, 1.1;
            for (int i = 0; i < s.n; ++i) t.x[i] = F * old.X[i] + 0.012 * shift[i];
            const auto f = s.force(controls, old, s.stressOf(controls, old, t, 1e-3));
            const double eps = 1e-6;
            Points<2> plus = t.x, minus = t.x;
            for (int i = 0; i < s.n; ++i) {
                plus[i] += eps * w[i];
                minus[i] -= eps * w[i];
            }
            const double slope = (energy(plus) - energy(minus)) / (2 * eps);
            EXPECT_GT(std::abs(slope), 1e3);
            EXPECT_NEAR(dot(f, w), slope, 1e-6 * std::abs(slope));
        }
}

TEST(SolidMass, isThatOfTheReferencePositions) {
    SolidCase s;
    const auto mass = solidMass<2>(s.c.problem, s.cells, s.c.state.nodes.X);
    const auto patches = s.patches(s.c.state.nodes.X);
    for (int i = 0; i < s.n; ++i) EXPECT_NEAR(mass[i], 1500 * patches.volume[i], 1e-10);
}

}  // namespace
