// The pressure matrix: its parts against the residual and against a dense elimination of the solid.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "continuity/continuitySystem.hpp"
#include "continuity/residual.hpp"
#include "continuity/stabilisation.hpp"
#include "momentum/mass.hpp"
#include "momentum/surfaceStiffness.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Controls of a system that is solved in double precision.
ContinuityControls exactly() {
    ContinuityControls controls;
    controls.factorPrecision = "double";
    controls.stabilisation = "inertia";  // whose operator is local
    return controls;
}

PFEM_BOTH_DIMENSIONS(PressureMatrix);

template <int Dim>
struct Coupled {
    CaseOf<Dim> c = irregular<Dim>();
    Topology<Dim> topology = c.topology();
    NodeConstraints<Dim> constraints = c.constraints(topology);
    const Points<Dim>& x = c.state.nodes.x;
    MidpointRule midpoint{2e-3};
    SmoothingDomains<Dim> fluid = makeSmoothingDomains<Dim>(c.state.mesh.fluid.nodes, topology.fluid, x);
    SmoothingDomains<Dim> solid = makeSmoothingDomains<Dim>(c.state.mesh.solid.nodes, topology.solid, x);
    PerCell<double> mu = PerCell<double>(c.state.mesh.fluid.size(), 3.0);  // of the water
    PerCell<double> tau = stabilisation<Dim>(c.problem, c.state.mesh.fluid, fluid, mu, c.state.nodes.v, midpoint.dt);
    int n = c.state.nodes.size();
    SolidDofs<Dim> dofs = solidDofs<Dim>(topology.solid, constraints);
    SymmetricMatrix A = solidMatrix();

    SymmetricMatrix solidMatrix() const {
        auto mass = fluidMass<Dim>(c.problem, c.state.mesh.fluid, fluid);
        const auto more = solidMass<Dim>(c.problem, c.state.mesh.solid, x);
        for (int i = 0; i < n; ++i) mass[i] += more[i];
        return pfem::solidMatrix<Dim>({c.problem, c.controls.solid, c.state.mesh.solid}, solid, dofs,
                                      matrixInertia<Dim>(mass, Points<Dim>(mass.size(), Vec<Dim>::Zero()), midpoint),
                                      c.state.nodes.h, midpoint);
    }
    PerCell<unsigned char> projected(const ContinuityControls& controls) const {
        return projectedCells<Dim>(controls, c.problem, c.state.mesh.fluid, topology, c.state.nodes);
    }
    Step<Dim> step(const Problem<Dim>& problem) const {
        return {problem, c.state.mesh, topology, constraints, c.state.nodes, midpoint};
    }
    FluidPhase<Dim> phase(const Problem<Dim>& problem) const {
        return {problem, c.state.mesh, topology.fluid, c.state.nodes, Integration::nodal};
    }
    ContinuitySystem<Dim> system(const ContinuityControls& controls) const {
        return {step(c.problem), controls, phase(c.problem), {tau, projected(controls)}, x, {dofs, A, nullptr}};
    }
    /// R_c of pressure p and velocities v without gravity.
    std::vector<double> residual(const PerCell<double>& stabilisationTime, const std::vector<double>& p,
                                 const Points<Dim>& v) const {
        Problem<Dim> problem = c.problem;
        problem.gravity.setZero();
        Nodes<Dim> trial = c.state.nodes;
        trial.p = p;
        trial.v = v;
        return continuityResidual<Dim>(step(problem), exactly(), phase(problem),
                                       {stabilisationTime, projected(exactly())},
                                       {trial, trial, {}, Vec<Dim>::Zero(), {}});
    }
    Points<Dim> still() const { return Points<Dim>(n, Vec<Dim>::Zero()); }
};

// Without the Schur term and the compliances, with M_G as it is, the matrix is dR_c/dp.
TYPED_TEST(PressureMatrix, isTheDerivativeOfTheResidual) {
    constexpr int Dim = TypeParam::value;
    Coupled<Dim> s;
    ContinuityControls controls = exactly();
    controls.schurScale = controls.complianceScale = controls.freeSurfaceScale = 0;
    auto R = randomNumbers(s.n, 1);
    const auto dp = s.system(controls).solve(R);
    const auto change = s.residual(s.tau, dp, s.still());
    for (int i = 0; i < s.n; ++i) {
        if (s.topology.wet(i)) {
            EXPECT_NEAR(change[i] + R[i], 0, 1e-9);
        } else
            EXPECT_EQ(dp[i], 0);
    }
}

TYPED_TEST(PressureMatrix, schurTermIsALargerStabilisation) {
    constexpr int Dim = TypeParam::value;
    Coupled<Dim> s;
    ContinuityControls controls = exactly();
    controls.complianceScale = controls.freeSurfaceScale = 0;
    controls.schurScale = 1.5;
    controls.freeSurfaceWeight = 3;
    auto R = randomNumbers(s.n, 1);
    const auto dp = s.system(controls).solve(R);
    // tau L + s dt/rho L, surface 3 tau_n M_G: from residuals with other taus
    PerCell<double> more = s.tau;
    for (double& t : more) t += 1.5 * s.midpoint.dt / 1000;
    const auto volume = s.residual(more, dp, s.still());
    std::vector<double> surface(s.n, 0.0);
    for (const auto& face : s.topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double length = faceArea<Dim>(s.x, face.nodes).norm();
        const double cell = s.fluid.element[face.cell].measure, height = Dim * cell / length;
        const auto tauN = [&](double tau) { return surfaceStabilisation<Dim>(tau, s.mu[face.cell], cell, length); };
        for (int node : face.nodes)
            surface[node] +=
                (3 * tauN(s.tau[face.cell]) - tauN(more[face.cell])) * 2 / height * length / Dim * dp[node];
    }
    for (int i = 0; i < s.n; ++i)
        if (s.topology.wet(i)) {
            EXPECT_NEAR(volume[i] + surface[i] + R[i], 0, 1e-9);
        }
}

// K_p dp + (c_s B A_s^-1 B^T dp + c_f B m^-1 B^T dp)/gamma = -R: with a dense elimination of the velocities of the
// elastic interface and of the free surface.
TYPED_TEST(PressureMatrix, complianceOfTheMovingBoundary) {
    constexpr int Dim = TypeParam::value;
    Coupled<Dim> s;
    s.c.problem.gravity.setZero();  // no surfaceStiffness
    ContinuityControls controls = exactly();
    controls.schurScale = 0;
    controls.complianceScale = 2;
    controls.freeSurfaceScale = 3;
    const auto R = randomNumbers(s.n, 1);
    const auto dp = s.system(controls).solve(R);

    const PerCell<double> zeroTau(s.tau.size(), 0.0);
    const std::vector<double> zero(s.n, 0.0);
    const auto divergence = [&](int node, const Vec<Dim>& direction) {
        Points<Dim> v = s.still();
        v[node] = direction;
        const auto Bv = s.residual(zeroTau, zero, v);
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(Bv.data(), s.n));
    };
    Eigen::MatrixXd A(s.dofs.n, s.dofs.n), B(s.n, s.dofs.n);
    for (std::size_t k = 0; k < s.dofs.node.size(); ++k)
        for (int i = 0; i < s.dofs.count[s.dofs.node[k]]; ++i) {
            const int column = s.dofs.first[s.dofs.node[k]] + i;
            Eigen::VectorXd unit = Eigen::VectorXd::Zero(s.dofs.n);
            unit[column] = 1;
            A.col(column) = s.A.multiply(unit);
            B.col(column) = divergence(s.dofs.node[k], s.dofs.basis[k].col(i));
        }
    EXPECT_LT((A - A.transpose()).norm(), 1e-12 * A.norm());
    const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(dp.data(), s.n);
    const Eigen::VectorXd elastic = 2 / s.midpoint.gamma * B * A.partialPivLu().solve(B.transpose() * q);
    Eigen::VectorXd surface = Eigen::VectorXd::Zero(s.n);
    for (int node = 0; node < s.n; ++node) {
        if (!s.topology.freeSurface[node] || s.topology.onSolid[node]) continue;
        for (int d = 0; d < Dim; ++d) {
            const auto b = divergence(node, Vec<Dim>::Unit(d));
            surface += 3 / s.midpoint.gamma * b.dot(q) / (s.midpoint.massFactor() * 1000 * s.fluid.volume[node]) * b;
        }
    }
    const auto rigid = s.residual(s.tau, dp, s.still());
    for (int i = 0; i < s.n; ++i)
        if (s.topology.wet(i)) {
            EXPECT_NEAR(rigid[i] + elastic[i] + surface[i] + R[i], 0, 1e-8);
        }
    EXPECT_GT(elastic.cwiseAbs().maxCoeff(), 0.1);
    EXPECT_GT(surface.cwiseAbs().maxCoeff(), 0.1);
}

TYPED_TEST(PressureMatrix, strongSurfaceHasNoUnknown) {
    constexpr int Dim = TypeParam::value;
    Coupled<Dim> s;
    ContinuityControls controls = exactly();
    controls.freeSurfacePressure = "strong";
    const auto system = s.system(controls);
    const auto dp = system.solve(randomNumbers(s.n, 1));
    for (int i = 0; i < s.n; ++i) {
        EXPECT_EQ(system.hasUnknown(i), s.topology.wet(i) && !s.topology.freeSurface[i]);
        if (s.topology.freeSurface[i]) {
            EXPECT_EQ(dp[i], 0);
        }
    }
}

TYPED_TEST(PressureMatrix, singlePrecisionIsForTheIteration) {
    constexpr int Dim = TypeParam::value;
    Coupled<Dim> s;
    const auto R = randomNumbers(s.n, 1);
    ContinuityControls inSingle = exactly();
    inSingle.factorPrecision = "single";
    const auto single = s.system(inSingle).solve(R), exact = s.system(exactly()).solve(R);
    double difference = 0, size = 0;
    for (int i = 0; i < s.n; ++i) {
        difference = std::max(difference, std::abs(single[i] - exact[i]));
        size = std::max(size, std::abs(exact[i]));
    }
    EXPECT_GT(difference, 0);
    EXPECT_LT(difference, 1e-5 * size);
}

}  // namespace
