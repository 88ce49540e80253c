// The one linear system for all velocities, and the terms of its right-hand side.

#include <gtest/gtest.h>

#include "material/viscosity.hpp"
#include "momentum/fluidStress.hpp"
#include "momentum/mass.hpp"
#include "momentum/momentumSystem.hpp"
#include "momentum/residual.hpp"
#include "momentum/surfaceStiffness.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

PFEM_BOTH_DIMENSIONS(MomentumSystems);
PFEM_BOTH_DIMENSIONS(SurfaceStiffness);
PFEM_BOTH_DIMENSIONS(MomentumResidual);
PFEM_BOTH_DIMENSIONS(MidpointRules);

// With dv from the system, mass, viscosity, bulk term and solid matrix together balance the residual on every free
// direction: the same operators as in the residual, each once, interface nodes included.
TYPED_TEST(MomentumSystems, solutionBalancesTheResidual) {
    constexpr int Dim = TypeParam::value;
    for (const double theta : {0.0, 1.0}) {
        CaseOf<Dim> c = irregular<Dim>();
        if (Dim == 3)  // larger cells: make it felt
            for (auto& m : c.problem.materials) m.fluid.law = newtonian(60);
        const auto topology = c.topology();
        const auto constraints = c.constraints(topology);
        const auto& x = c.state.nodes.x;
        const int n = c.state.nodes.size();
        const MidpointRule midpoint{1e-2};
        const auto fluid = makeSmoothingDomains<Dim>(c.state.mesh.fluid.nodes, topology.fluid, x);
        const auto solid = makeSmoothingDomains<Dim>(c.state.mesh.solid.nodes, topology.solid, x);
        auto mass = fluidMass<Dim>(c.problem, c.state.mesh.fluid, fluid);
        const auto massOfSolid = solidMass<Dim>(c.problem, c.state.mesh.solid, x);
        for (int i = 0; i < n; ++i) mass[i] += massOfSolid[i];
        const auto dofs = solidDofs<Dim>(topology.solid, constraints);
        Points<Dim> positive = someVectors<Dim>(n, 6);
        for (auto& u : positive) u = 1e3 * u.cwiseAbs();
        const auto inertia = matrixInertia<Dim>(mass, positive, midpoint);
        const auto A = solidMatrix<Dim>({c.problem, c.controls.solid, c.state.mesh.solid}, solid, dofs, inertia,
                                        c.state.nodes.h, midpoint);
        MomentumControls controls;
        controls.theta = theta;
        controls.linearTolerance = 1e-13;
        const FluidPhase<Dim> phase(c.problem, c.state.mesh, topology.fluid, c.state.nodes, Integration::nodal);
        const Step<Dim> step{c.problem, c.state.mesh, topology, constraints, c.state.nodes, midpoint};
        MomentumSystem<Dim> system(step, controls, phase, inertia, {dofs, A});

        Points<Dim> R = someVectors<Dim>(n, 4);
        const auto dv = system.solve(R);
        EXPECT_GT(system.linearIterations(), 1);

        std::vector<double> bulk;
        if (theta > 0)
            for (double volume : fluid.volume) bulk.push_back(theta * 1000 * std::pow(volume, 2.0 / Dim) / midpoint.dt);
        Points<Dim> sum = R;
        addInternalForce<Dim>(fluid, fluidTangentStress<Dim>(fluid, phase.viscosity, dv, PerPoint<double>(bulk)), sum);
        Eigen::VectorXd u(dofs.n);
        for (std::size_t k = 0; k < dofs.node.size(); ++k) u.segment<Dim>(dofs.first[dofs.node[k]]) = dv[dofs.node[k]];
        const Eigen::VectorXd Au = A.multiply(u);  // carries the fluid's mass at the interface too
        for (int i = 0; i < n; ++i) {
            if (dofs.local[i] >= 0)
                sum[i] += Au.segment<Dim>(dofs.first[i]);
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
TYPED_TEST(SurfaceStiffness, isThatOfGravityWaves) {
    constexpr int Dim = TypeParam::value;
    const CaseOf<Dim> c = [] {
        if constexpr (Dim == 2)
            return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                                " } ); walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                            water, "tank { type slip; }");
        else
            return boxOfWater({0.4, 0.3, 0.5}, {0.4, 0.3, 0.8}, 0.1);
    }();
    constexpr int up = Dim - 1;
    const auto topology = c.topology();
    const MidpointRule midpoint{1e-2, 0.7};
    const auto stiffness = surfaceStiffness<Dim>(c.problem, c.state.mesh.fluid, topology, c.state.nodes.x, midpoint);
    Points<Dim> x = c.state.nodes.x;
    const double du = 1e-3;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.freeSurface[i]) x[i][up] += du;
    // pressure of the water at rest, carried to the lifted surface: -rho g du there
    std::vector<double> p(x.size(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = 1000 * 9.81 * (0.5 - x[i][up]);
    const auto patches = makeSmoothingDomains<Dim>(c.state.mesh.fluid.nodes, topology.fluid, x);
    const auto mass = fluidMass<Dim>(c.problem, c.state.mesh.fluid, patches);
    Points<Dim> R(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) R[i] = -mass[i] * c.problem.gravity;
    addPressureForce<Dim>(patches, p, R);
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        EXPECT_EQ(stiffness[i].template head<up>().norm(), 0);
        EXPECT_NEAR(stiffness[i][up], topology.freeSurface[i] ? R[i][up] / du * 0.5 * midpoint.dt : 0, 1e-9);
    }
}

// d(residual)/dv of the inertia over gamma: massFactor m, with the midpoint rule 2 m/dt.
TYPED_TEST(MomentumResidual, inertiaAgainstFiniteDifferences) {
    constexpr int Dim = TypeParam::value;
    const CaseOf<Dim> c = irregular<Dim>();
    const auto topology = c.topology();
    const auto& nodes = c.state.nodes;
    const FluidPhase<Dim> fluid(c.problem, c.state.mesh, topology.fluid, nodes, Integration::nodal);
    const SolidPhase<Dim> solid(c.problem, c.controls.solid, c.state.mesh, topology.solid, nodes, Integration::nodal);
    const auto mass = nodalMass<Dim>(fluid, solid);
    const Points<Dim> none(nodes.size(), Vec<Dim>::Zero());
    const auto vOld = someVectors<Dim>(nodes.size(), 1), v = someVectors<Dim>(nodes.size(), 2),
               w = someVectors<Dim>(nodes.size(), 3);
    for (const double gamma : {0.5, 1.0}) {
        const MidpointRule midpoint{1e-2, gamma};
        const auto residual = [&](double change) {
            Nodes<Dim> moved = nodes;
            for (int i = 0; i < nodes.size(); ++i)
                moved.a[i] = midpoint.template acceleration<Dim>(vOld[i], v[i] + change * w[i]);
            return momentumResidual<Dim>(mass, moved, fluid, solid, none, gamma);
        };
        const double eps = 1e-3;
        const auto plus = residual(eps), minus = residual(-eps);
        for (int i = 0; i < nodes.size(); ++i) {
            const Vec<Dim> slope = (plus[i] - minus[i]) / (2 * eps) / gamma,
                           exact = midpoint.massFactor() * mass[i] * w[i];
            EXPECT_LT((slope - exact).norm(), 1e-6) << i;
            EXPECT_GT(exact.norm(), 1);
            EXPECT_LT((matrixInertia<Dim>(mass[i], Vec<Dim>::Zero(), midpoint).cwiseProduct(w[i]) - exact).norm(),
                      1e-9);
        }
    }
    EXPECT_NEAR(MidpointRule{1e-2}.massFactor(), 2 / 1e-2, 1e-12);
}

TYPED_TEST(MidpointRules, constantAccelerationIsExact) {
    constexpr int Dim = TypeParam::value;
    for (const double gamma : {0.5, 0.75, 1.0}) {
        const MidpointRule midpoint{0.1, gamma};
        const auto some = someVectors<Dim>(3, 5);
        const Vec<Dim> a = 10 * some[0];
        const Vec<Dim>&v = some[1], &x = some[2];
        const Vec<Dim> next = v + 0.1 * a;
        EXPECT_LT((midpoint.template acceleration<Dim>(v, next) - a).norm(), 1e-13);
        EXPECT_LT((midpoint.template position<Dim>(x, v, next) - (x + 0.1 * v + 0.005 * a)).norm(), 1e-15);
    }
}

/// A block of 1 x 0.5 m, in space 0.4 m wide, pulled at its end x = 1.
template <int Dim>
CaseOf<Dim> pulledBlock() {
    const std::string pull = "end { type traction; traction (7 -3 " + std::string(Dim == 2 ? "0" : "2") + "); }";
    if constexpr (Dim == 2) {
        return makeCase("meshSize 0.1; bodies ( block { type solid; material rubber; " + rectangle(0, 0, 1, 0.5) +
                            " patches { end { edges ((1 2)); } } } );",
                        rubber, pull);
    } else {
        TestCase3 c = onLattice(
            Vec<3>::Zero(), {1, 0.5, 0.4}, 0.1, [](const Vec<3>&) { return false; }, [](const Vec<3>&) { return true; },
            water + rubber);
        c.state.mesh.patches.push_back(solidPatch(c.state, "end", [](const Vec<3>& x) { return x[0] > 1 - 1e-9; }));
        setConditions(c, pull);
        return c;
    }
}

TYPED_TEST(MomentumResidual, weightTractionAndInertia) {
    constexpr int Dim = TypeParam::value;
    const CaseOf<Dim> c = pulledBlock<Dim>();
    const double area = Dim == 2 ? 0.5 : 0.2;
    const auto topology = c.topology();
    const auto& nodes = c.state.nodes;
    const auto traction = tractionForce<Dim>(c.state.mesh, c.problem.conditions, nodes.x);
    Vec<Dim> total = Vec<Dim>::Zero();
    double corner = 0, middle = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        total += traction[i];
        Vec<Dim> ofCorner = Vec<Dim>::UnitX(), inside = Vec<Dim>::Constant(0.2);
        inside[0] = 1;
        if ((nodes.x[i] - ofCorner).norm() < 1e-9) corner = traction[i][0];
        if ((nodes.x[i] - inside).norm() < 1e-9) middle = traction[i][0];
    }
    EXPECT_LT((total - area * Vec<3>(7, -3, 2).head<Dim>()).norm(), 1e-12);
    EXPECT_NEAR(middle, 7 * std::pow(0.1, Dim - 1), 1e-9);  // the faces of a whole cell
    if (Dim == 2) {
        EXPECT_NEAR(corner / middle, 0.5, 1e-9);  // half an edge each
    } else
        EXPECT_TRUE(std::abs(corner / middle - 1.0 / 3) < 1e-9 || std::abs(corner / middle - 1.0 / 6) < 1e-9);

    const Vec<Dim> a = Vec<3>(0.5, 0.25, -0.3).head<Dim>(), g = c.problem.gravity;
    Nodes<Dim> moved = nodes;
    moved.a.assign(nodes.size(), a);
    const FluidPhase<Dim> fluid(c.problem, c.state.mesh, topology.fluid, nodes, Integration::nodal);
    const SolidPhase<Dim> solid(c.problem, c.controls.solid, c.state.mesh, topology.solid, nodes, Integration::nodal);
    const auto R = momentumResidual<Dim>(nodalMass<Dim>(fluid, solid), moved, fluid, solid, traction, 1);
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const auto& r : R) sum += r;
    EXPECT_LT((sum - (1500 * area * (a - g) - total)).norm(), 1e-9);
}

}  // namespace
