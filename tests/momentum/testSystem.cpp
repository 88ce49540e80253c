// The one linear system for all velocities, and the terms of its right-hand side.

#include <gtest/gtest.h>

#include "momentum/fluidStress.hpp"
#include "momentum/mass.hpp"
#include "momentum/momentumSystem.hpp"
#include "momentum/residual.hpp"
#include "momentum/surfaceStiffness.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

// With dv from the system, mass, viscosity, bulk term and solid matrix together balance the residual on every free
// direction: the same operators as in the residual, each once, interface nodes included.
TEST(MomentumSystem, solutionBalancesTheResidual) {
    for (const double theta : {0.0, 1.0}) {
        TestCase c = irregularPair();
        const auto topology = c.topology();
        const auto constraints = c.constraints(topology);
        const auto& x = c.state.nodes.x;
        const int n = c.state.nodes.size();
        const MidpointRule midpoint{1e-2};
        const auto fluid = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, x);
        const auto solid = makeSmoothingDomains<2>(c.state.mesh.solid.nodes, topology.solid, x);
        auto mass = fluidMass<2>(c.problem, c.state.mesh.fluid, fluid);
        const auto massOfSolid = solidMass<2>(c.problem, c.state.mesh.solid, x);
        for (int i = 0; i < n; ++i) mass[i] += massOfSolid[i];
        const auto dofs = solidDofs<2>(topology.solid, constraints);
        Points<2> positive = randomVectors(n, 6);
        for (auto& u : positive) u = 1e3 * u.cwiseAbs();
        const auto inertia = matrixInertia<2>(mass, positive, midpoint);
        const auto A = solidMatrix<2>({c.problem, c.controls.solid, c.state.mesh.solid}, solid, dofs, inertia,
                                      c.state.nodes.h, midpoint);
        MomentumControls controls;
        controls.theta = theta;
        controls.linearTolerance = 1e-13;
        const FluidPhase<2> phase(c.problem, c.state.mesh, topology.fluid, c.state.nodes, Integration::nodal);
        const Step<2> step{c.problem, c.state.mesh, topology, constraints, c.state.nodes, midpoint};
        MomentumSystem<2> system(step, controls, phase, inertia, {dofs, A});

        Points<2> R = randomVectors(n, 4);
        const auto dv = system.solve(R);
        EXPECT_GT(system.linearIterations(), 1);

        std::vector<double> bulk;
        if (theta > 0)
            for (double volume : fluid.volume) bulk.push_back(theta * 1000 * volume / midpoint.dt);
        Points<2> sum = R;
        addInternalForce<2>(fluid, fluidTangentStress<2>(fluid, phase.viscosity, dv, PerPoint<double>(bulk)), sum);
        Eigen::VectorXd u(dofs.n);
        for (std::size_t k = 0; k < dofs.node.size(); ++k) u.segment<2>(dofs.first[dofs.node[k]]) = dv[dofs.node[k]];
        const Eigen::VectorXd Au = A.multiply(u);  // carries the fluid's mass at the interface too
        for (int i = 0; i < n; ++i) {
            if (dofs.local[i] >= 0)
                sum[i] += Au.segment<2>(dofs.first[i]);
            else if (!topology.onSolid[i])
                sum[i] += inertia[i].cwiseProduct(dv[i]);
            sum[i] = constraints.project(i, sum[i]);
            if (!constraints.freedom[i].any()) {
                EXPECT_EQ(dv[i].norm(), 0);
            }
        }
        EXPECT_LT(largest(sum), 1e-10) << theta;
    }
}

// A node that hangs on one flat triangle is light, and viscosity counts there; that does not make the water a thick
// fluid.
TEST(MomentumSystem, aFewLightNodesDoNotMakeAThickFluid) {
    const auto number = [](double mu, double flat) {
        TestCase c = makeCase("meshSize 0.02; bodies ( water { type fluid; material water; pattern oneWay; " +
                                  rectangle(0, 0, 1, 1) + " } );",
                              "water { type newtonian; rho 1000; mu " + std::to_string(mu) + "; kappa 2.1e9; }", "");
        const auto topology = c.topology();
        int light = -1;
        for (int i = 0; i < c.state.nodes.size(); ++i)
            if (topology.fluid.count(i) == 1) {
                light = i;
                const auto& s = c.state.mesh.fluid.nodes[topology.fluid.cell[topology.fluid.start[i]]];
                const Vec<2> base =
                    0.5 * (c.state.nodes.x[s[0]] + c.state.nodes.x[s[1]] + c.state.nodes.x[s[2]] - c.state.nodes.x[i]);
                c.state.nodes.x[i] = base + flat * (c.state.nodes.x[i] - base);
            }
        const auto constraints = c.constraints(topology);
        const MidpointRule midpoint{1e-3};
        const auto fluid = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, c.state.nodes.x);
        const auto mass = fluidMass<2>(c.problem, c.state.mesh.fluid, fluid);
        const FluidPhase<2> phase(c.problem, c.state.mesh, topology.fluid, c.state.nodes, Integration::nodal);
        const Step<2> step{c.problem, c.state.mesh, topology, constraints, c.state.nodes, midpoint};
        MomentumSystem<2> system(step, {}, phase,
                                 matrixInertia<2>(mass, Points<2>(mass.size(), Vec<2>::Zero()), midpoint),
                                 {solidDofs<2>(topology.solid, constraints), {}});
        EXPECT_GE(light, 0);
        Points<2> R(c.state.nodes.size(), Vec<2>::Zero());
        R[light] = {1, 0};
        const double inertia = midpoint.massFactor() * mass[light];
        return std::tuple(system.viscousNumber(), system.isViscous(), -1 / (system.solve(R)[light][0] * inertia) - 1);
    };
    const auto [water, waterIsThick, waterRatio] = number(0.1, 1);
    EXPECT_GT(water, 1e-4);
    EXPECT_LT(water, 1e-2);
    EXPECT_FALSE(waterIsThick);
    EXPECT_NEAR(waterRatio, 0, 1e-12);  // only mass is in the matrix
    const auto [withLight, lightIsThick, lightRatio] = number(0.1, 0.1);
    EXPECT_EQ(withLight, water);
    EXPECT_GT(lightRatio, 0.01);  // it alone is above the limit: the diagonal, too
    EXPECT_FALSE(lightIsThick);
    EXPECT_TRUE(std::get<1>(number(0.1, 1e-5)));  // there the diagonal would not do
    const auto [honey, honeyIsThick, honeyRatio] = number(0.1 * 1024, 1);
    EXPECT_EQ(honey, 1024 * water);
    EXPECT_TRUE(honeyIsThick);
}

// A flat surface that rises as a whole by u: the force on it is rho g u per length, downwards; half of it, over gamma,
// is gamma dt/2 dv.
TEST(SurfaceStiffness, isThatOfGravityWaves) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                          water, "tank { type slip; }");
    const auto topology = c.topology();
    const MidpointRule midpoint{1e-2, 0.7};
    const auto stiffness = surfaceStiffness<2>(c.problem, c.state.mesh.fluid, topology, c.state.nodes.x, midpoint);
    Points<2> x = c.state.nodes.x;
    const double du = 1e-3;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.freeSurface[i]) x[i][1] += du;
    // pressure of the water at rest, carried to the lifted surface: -rho g du there
    std::vector<double> p(x.size(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = 1000 * 9.81 * (0.5 - x[i][1]);
    const auto patches = makeSmoothingDomains<2>(c.state.mesh.fluid.nodes, topology.fluid, x);
    const auto mass = fluidMass<2>(c.problem, c.state.mesh.fluid, patches);
    Points<2> R(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) R[i] = -mass[i] * c.problem.gravity;
    addPressureForce<2>(patches, p, R);
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        EXPECT_EQ(stiffness[i][0], 0);
        EXPECT_NEAR(stiffness[i][1], topology.freeSurface[i] ? R[i][1] / du * 0.5 * midpoint.dt : 0, 1e-9);
    }
}

// d(residual)/dv of the inertia over gamma: 1/(gamma dt) m, with the midpoint rule 2 m/dt.
TEST(MomentumResidual, inertiaAgainstFiniteDifferences) {
    const MidpointRule midpoint{1e-2};
    const Vec<2> vOld(1, -2), v(1.1, -1.7), w(0.3, 0.9);
    const double eps = 1e-3;
    const Vec<2> slope =
        (midpoint.acceleration<2>(vOld, v + eps * w) - midpoint.acceleration<2>(vOld, v - eps * w)) / (2 * eps);
    EXPECT_LT((slope - midpoint.gamma * midpoint.massFactor() * w).norm(),
              1e-9);  // the forces' derivative is by v^{n+1}
    EXPECT_NEAR(midpoint.massFactor(), 2 / 1e-2, 1e-12);
}

TEST(MidpointRule, constantAccelerationIsExact) {
    for (const double gamma : {0.5, 0.75, 1.0}) {
        const MidpointRule midpoint{0.1, gamma};
        const Vec<2> a(0, -9.81), v(1, 2), x(3, 4);
        const Vec<2> next = v + 0.1 * a;
        EXPECT_LT((midpoint.acceleration<2>(v, next) - a).norm(), 1e-13);
        EXPECT_LT((midpoint.position<2>(x, v, next) - (x + 0.1 * v + 0.005 * a)).norm(), 1e-15);
    }
}

TEST(MomentumResidual, weightTractionAndInertia) {
    TestCase c = makeCase("meshSize 0.1; bodies ( block { type solid; material rubber; " + rectangle(0, 0, 1, 0.5) +
                              " patches { end { edges ((1 2)); } } } );",
                          rubber, "end { type traction; traction (7 -3 0); }");
    const auto topology = c.topology();
    const auto& nodes = c.state.nodes;
    const auto traction = tractionForce<2>(c.state.mesh, c.problem.conditions, nodes.x);
    Vec<2> total = Vec<2>::Zero();
    for (const auto& f : traction) total += f;
    EXPECT_LT((total - 0.5 * Vec<2>(7, -3)).norm(), 1e-12);
    const int corner = nearestNode(nodes.x, {1, 0}), middle = nearestNode(nodes.x, {1, 0.25});
    EXPECT_NEAR(traction[corner][0] / traction[middle][0], 0.5, 1e-9);  // half an edge each

    const Vec<2> a(0.5, 0.25), g(0, -9.81);
    Nodes<2> moved = nodes;
    moved.a.assign(nodes.size(), a);
    const FluidPhase<2> fluid(c.problem, c.state.mesh, topology.fluid, nodes, Integration::nodal);
    const SolidPhase<2> solid(c.problem, c.controls.solid, c.state.mesh, topology.solid, nodes, Integration::nodal);
    const auto R = momentumResidual<2>(nodalMass<2>(fluid, solid), moved, fluid, solid, traction, 1);
    Vec<2> sum = Vec<2>::Zero();
    for (const auto& r : R) sum += r;
    EXPECT_LT((sum - (1500 * 0.5 * (a - g) - total)).norm(), 1e-9);
}

}  // namespace
