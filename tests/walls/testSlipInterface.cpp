// Fluid that slides over solids (slipInterface): rest, forces in balance, streams without friction and with it.

#include <gtest/gtest.h>

#include <numeric>

#include "continuity/residual.hpp"
#include "continuity/riderColumns.hpp"
#include "functions/forces.hpp"
#include "momentum/mass.hpp"
#include "solver/beginStep.hpp"
#include "solver/fsiStep.hpp"
#include "support/bothDimensions.hpp"
#include "walls/skins.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TestCase slippery(const std::string& mesh, const std::string& materials, const std::string& conditions,
                  const Vec<2>& gravity = {0, -9.81}) {
    TestCase c = makeCase(mesh, materials, conditions, gravity);
    separateFromSkins<2>(c.kinds(), c.state);
    return c;
}

/// Nodes of the fluid go along the solid's skin by up to `part` of h, so that they are not where the solid's are.
void shiftAlongSkin(TestCase& c, double part) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-part, part);
    const auto topology = c.topology();
    auto& nodes = c.state.nodes;
    for (const auto& ride : topology.rides) {
        if (nSupports(nodes.wall[ride.node]) > 1) continue;
        const Vec<2> along = (nodes.x[ride.face[1]] - nodes.x[ride.face[0]]).normalized();
        nodes.x[ride.node] += shift(random) * nodes.h[ride.node] * along;
        nodes.wall[ride.node][0] = placeOnRegion<2>(topology.walls, nodes.x, ride.wall, nodes.x[ride.node]).face;
    }
}

/// A block in the middle of a tank of 0.4 m with 0.3 m of water.
TestCase immersed(const std::string& solid) {
    return slippery(
        "meshSize 0.025; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.4, 0.3) +
            " holes (block); } block { type solid; material body; " + rectangle(0.15, 0.1, 0.25, 0.2) +
            " patches { skin { edges ((0 1) (1 2) (2 3) (3 0)); } } } ); walls ( tank { points ((0 0.5) (0 0) (0.4 0) "
            "(0.4 0.5)); } );",
        water + solid, "tank { type slip; } skin { type slipInterface; }");
}

double fastest(const TestCase& c) { return largest(c.state.nodes.v); }

TEST(SlipInterface, fluidHasNodesOfItsOwn) {
    TestCase c = immersed("body { type hypoelastic; rho 1000; E 1e6; nu 0.3; }");
    const auto topology = c.topology();
    EXPECT_EQ(topology.rides.size(), 16u + 4u);  // corners ride on two sides
    for (const auto& cell : c.state.mesh.fluid.nodes)
        for (const int i : cell) EXPECT_FALSE(topology.onSolid[i]);
    for (const auto& face : topology.faces) EXPECT_NE(face.kind, FaceKind::interface);
    for (const auto& ride : topology.rides)
        EXPECT_LT((ride.under(c.state.nodes.x) - c.state.nodes.x[ride.node]).norm(), 1e-15);
}

// The solid has water's density and pressure: everything stays where it is, wherever the fluid's nodes are.
TEST(SlipInterface, restIsExact) {
    for (const auto* law : {"hypoelastic; rho 1000; E 1e6; nu 0.3", "rigid; rho 1000"}) {
        TestCase c = immersed(std::string("body { type ") + law + "; }");
        auto& nodes = c.state.nodes;
        const auto topology = c.topology();
        for (int i = 0; i < nodes.size(); ++i)
            if (topology.onSolid[i]) nodes.sigma[i].head<3>().setConstant(-1000 * 9.81 * (0.3 - nodes.x[i][1]));
        shiftAlongSkin(c, 0.2);
        c.tolerance(1e-8);
        c.start(0.01);
        for (int n = 0; n < 10; ++n) {
            const auto report = c.step(0.01);
            ASSERT_EQ(report.rejected, 0) << law << report.reasons.front();
        }
        std::cout << law << ": " << fastest(c) << " m/s\n";
        EXPECT_LT(fastest(c), 1e-10);
        for (int i = 0; i < nodes.size(); ++i)
            if (c.topology().wet(i)) {
                EXPECT_NEAR(nodes.p[i], 1000 * 9.81 * (0.3 - nodes.x[i][1]), 1e-6);
            }
    }
}

/// A block of water of 0.4 x 0.1 m on a plate 1.5 m long and 0.05 m thick that is held from below; no gravity.
TestCase onPlate(const std::string& entries) {
    return slippery("meshSize 0.025; bodies ( plate { type solid; material body; " + rectangle(0, -0.05, 1.5, 0) +
                        " patches { base { edges ((0 1)); } skin { edges ((2 3)); } } } water { type fluid; material "
                        "water; velocity "
                        "(1 0); " +
                        rectangle(0.1, 0, 0.5, 0.1) + " } );",
                    water + "body { type hypoelastic; rho 1500; E 1e6; nu 0.3; }",
                    "base { type clamped; } skin { type slipInterface; " + entries + " }", {0, 0});
}

Vec<2> momentumOf(const TestCase& c, const std::vector<double>& mass) {
    Vec<2> sum = Vec<2>::Zero();
    for (int i = 0; i < c.state.nodes.size(); ++i) sum += mass[i] * c.state.nodes.v[i];
    return sum;
}

// Over many faces of the plate, and nothing is felt.
TEST(SlipInterface, aStreamHasNoFriction) {
    TestCase c = onPlate("");
    c.tolerance(1e-12);
    c.start(0.01);
    for (int n = 0; n < 30; ++n) ASSERT_EQ(c.step(0.01).rejected, 0);
    const auto topology = c.topology();
    ASSERT_GT(topology.rides.size(), 10u);
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        if (topology.wet(i)) {
            EXPECT_LT((c.state.nodes.v[i] - Vec<2>(1, 0)).norm(), 1e-9);
        }
        if (topology.onSolid[i]) {
            EXPECT_LT((c.state.nodes.x[i] - c.state.nodes.X[i]).norm(), 1e-9);
        }
    }
    EXPECT_NEAR(fluidForce<2>(c.problem, c.state, {}, {c.state.mesh.solid.material[0]}).viscous.force[0], 0, 1e-9);
}

// rho c_f u^2/2 on the whole length, on the water and on the plate.
TEST(SlipInterface, frictionIsThatOfWalls) {
    const double cf = 0.01;
    TestCase c = onPlate("friction " + std::to_string(cf) + ";");
    c.tolerance(1e-12);
    c.start(1e-3);
    const auto mass = fluidMass<2>(c.problem, c.state.mesh.fluid, c.state.nodes.x);
    const double before = momentumOf(c, mass)[0];
    ASSERT_EQ(c.step(1e-3).rejected, 0);
    const double force = -0.5 * 1000 * cf * 0.4;
    EXPECT_NEAR((momentumOf(c, mass)[0] - before) / 1e-3, force, 2e-3 * std::abs(force));
    for (const auto& [patches, solids] :
         {std::pair(std::vector<int>{1}, std::vector<int>{}),
          std::pair(std::vector<int>{}, std::vector<int>{c.state.mesh.solid.material[0]})})
        EXPECT_NEAR(fluidForce<2>(c.problem, c.state, patches, solids).viscous.force[0], -force,
                    2e-3 * std::abs(force));
}

// Nothing from outside: what a step changes of the momenta of water and solid adds up to nothing, though the water
// strikes the solid obliquely and rubs it.
TEST(SlipInterface, momentumIsHandedOver) {
    const std::string elastic = "hypoelastic; rho 1500; E 1e6; nu 0.3", rigid = "rigid; rho 1500";
    const std::string syrup = "water { type newtonian; rho 1000; mu 10; kappa 2.1e9; }";
    const std::vector<std::pair<std::string, std::string>> cases{
        {water, elastic}, {water, rigid}, {syrup, elastic}, {syrup, rigid}};
    for (const auto& [fluid, law] : cases) {
        TestCase c =
            slippery("meshSize 0.025; bodies ( plate { type solid; material body; " + rectangle(0, -0.05, 0.6, 0) +
                         " patches { skin { edges ((1 2) (2 3)); } } } water { type fluid; material water; " +
                         rectangle(0.1, 0, 0.5, 0.1) + " } );",
                     fluid + "body { type " + law + "; }", "skin { type slipInterface; friction 0.1; }", {0, 0});
        shiftAlongSkin(c, 0.2);
        const auto shake = randomVectors(c.state.nodes.size(), 11);
        for (int i = 0; i < c.state.nodes.size(); ++i)
            if (c.topology().wet(i)) c.state.nodes.v[i] = Vec<2>(1, -0.5) + 0.1 * shake[i];
        c.tolerance(1e-12);
        const double dt = 1e-3;
        const auto [topology, constraints] = beginStep<2>(c.problem, dt, c.state);
        const Nodes<2>& old = c.state.nodes;
        const Nodes<2> now =
            fsiStep<2>({c.problem, c.state.mesh, topology, constraints, old, {dt, 0.5}}, c.controls).nodes;
        Points<2> middle;
        for (int i = 0; i < now.size(); ++i) middle.push_back(0.5 * (old.x[i] + now.x[i]));
        auto mass = fluidMass<2>(c.problem, c.state.mesh.fluid, middle);
        const auto ofSolid = solidMass<2>(c.problem, c.state.mesh.solid, now.X);
        Vec<2> given = Vec<2>::Zero(), taken = given;
        for (int i = 0; i < now.size(); ++i) {
            given -= mass[i] * (now.v[i] - old.v[i]);
            taken += ofSolid[i] * (now.v[i] - old.v[i]);
        }
        const auto bodies = constraints.bodies;
        if (!bodies.empty()) {
            Points<2> v;
            for (const int i : bodies[0].nodes) v.push_back(now.v[i]);
            taken = bodies[0].mass * nearestTwist<2>(bodies[0].arm, v).head<2>();
        }
        EXPECT_GT(given.norm(), 1);
        std::cout << (given - taken).norm() / given.norm() << "\n";
        EXPECT_LT((given - taken).norm(), 1e-11 * given.norm()) << law;
    }
}

/// In space: a cube of water's density in a box, the fluid's nodes shifted along its sides.
TestCase3 immersedCube(const std::string& law) {
    const auto isIn = [](const Vec<3>& x) { return (x - Vec<3>(0.3, 0.3, 0.25)).cwiseAbs().maxCoeff() < 0.1; };
    TestCase3 c = onLattice(
        Vec<3>::Zero(), {0.6, 0.6, 0.5}, 0.1, [&](const Vec<3>& x) { return !isIn(x); }, isIn,
        water + "body { type " + law + "; }");
    c.state.mesh.patches.push_back(openBox(c.state, "tank", {0.6, 0.6, 1}));
    c.state.mesh.patches.push_back(solidPatch(c.state, "skin", [](const Vec<3>&) { return true; }));
    c.problem.conditions = readBoundaryConditions<3>(
        Dictionary::parse("tank { type slip; } skin { type slipInterface; }", "boundaryConditions"),
        c.state.mesh.patches);
    separateFromWalls<3>({true, false}, c.state);
    separateFromSkins<3>(c.kinds(), c.state);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-0.015, 0.015);
    auto& nodes = c.state.nodes;
    for (const auto& ride : c.topology().rides) {
        if (nSupports(nodes.wall[ride.node]) > 1) continue;
        const auto basis = basisAround<3>(inwardNormal<3>(nodes.x, ride.face));
        nodes.x[ride.node] += shift(random) * basis.col(0) + shift(random) * basis.col(1);
    }
    return c;
}

TEST(SlipInterface, restIsExactInSpace) {
    TestCase3 c = immersedCube("rigid; rho 1000");
    ASSERT_GT(c.topology().rides.size(), 20u);
    c.tolerance(1e-8);
    c.start(0.01);
    for (int n = 0; n < 5; ++n) {
        const auto report = c.step(0.01);
        ASSERT_EQ(report.rejected, 0) << report.reasons.front();
    }
    std::cout << largest(c.state.nodes.v) << " m/s\n";
    EXPECT_LT(largest(c.state.nodes.v), 1e-10);
}

PFEM_BOTH_DIMENSIONS(Riders);

/// A block under water, of an elastic or a rigid solid, and what a step begins with.
template <int Dim>
struct Immersed {
    CaseOf<Dim> c;
    StepStart<Dim> start;
    SolidDofs<Dim> dofs;
    Eigen::VectorXd U;  // some velocities of the solid's unknowns

    explicit Immersed(const std::string& law) {
        if constexpr (Dim == 2) {
            c = immersed("body { type " + law + "; }");
            shiftAlongSkin(c, 0.2);
        } else {
            c = immersedCube(law);
        }
        c.problem.gravity.setZero();
        start = beginStep<Dim>(c.problem, 0.01, c.state);
        dofs = solidDofs<Dim>(start.topology.solid, start.constraints);
        const auto some = randomNumbers(dofs.n, 4);
        U = Eigen::Map<const Eigen::VectorXd>(some.data(), dofs.n);
    }
    /// U at the solid's nodes, and what it carries along.
    Points<Dim> velocities() const {
        Points<Dim> v(c.state.nodes.size(), Vec<Dim>::Zero());
        for (std::size_t l = 0; l < dofs.node.size(); ++l)
            for (int k = 0; k < dofs.count[dofs.node[l]]; ++k)
                v[dofs.node[l]] += U[dofs.first[dofs.node[l]] + k] * dofs.basis[l].col(k);
        carryRiders<Dim>(start.constraints.riders, v);
        return v;
    }
    /// Forces on the solid's unknowns.
    Eigen::VectorXd gather(const Points<Dim>& force) const {
        Eigen::VectorXd f = Eigen::VectorXd::Zero(dofs.n);
        for (std::size_t l = 0; l < dofs.node.size(); ++l)
            f.segment(dofs.first[dofs.node[l]], dofs.count[dofs.node[l]]) +=
                dofs.basis[l].transpose() * force[dofs.node[l]];
        return f;
    }
};

const std::array<std::string, 2> immersedLaws{"hypoelastic; rho 1000; E 1e6; nu 0.3", "rigid; rho 1000"};

// In the solid's matrix: the force, handed over, that the mass of the riders asks for when the solid carries them.
TYPED_TEST(Riders, theirMassIsInTheSolidsMatrix) {
    constexpr int Dim = TypeParam::value;
    for (const auto& law : immersedLaws) {
        const Immersed<Dim> s(law);
        const auto& nodes = s.c.state.nodes;
        const auto& riders = s.start.constraints.riders;
        const auto numbers = randomNumbers(nodes.size(), 7);
        Points<Dim> inertia;
        for (const double m : numbers) inertia.push_back(Vec<Dim>::Constant(50 + 40 * m));
        const auto domains = makeSmoothingDomains<Dim>(s.c.state.mesh.solid.nodes, s.start.topology.solid, nodes.x);
        SolidBlock<Dim> block{s.dofs, {}};
        block.matrix = solidMatrix<Dim>({s.c.problem, s.c.controls.solid, s.c.state.mesh.solid}, domains, s.dofs,
                                        Points<Dim>(nodes.size(), Vec<Dim>::Zero()), nodes.h, MidpointRule{0.01});
        const Eigen::VectorXd without = block.matrix.multiply(s.U);
        addRiders<Dim>(riders, inertia, block);
        const Eigen::VectorXd added = block.matrix.multiply(s.U) - without;
        const Points<Dim> v = s.velocities();
        Points<Dim> force(nodes.size(), Vec<Dim>::Zero());
        for (const auto& rider : riders)
            force[rider.ride.node] = inertia[rider.ride.node].cwiseProduct(v[rider.ride.node]);
        handOver<Dim>(riders, force);
        EXPECT_GT(added.norm(), 10) << law;
        EXPECT_LT((added - s.gather(force)).norm(), 1e-10 * (added.norm() + without.norm())) << law;
    }
}

// The columns of the pressure's matrix: the derivative of the continuity equation by the solid's unknowns.
TYPED_TEST(Riders, columnsAreTheDerivativeOfTheContinuity) {
    constexpr int Dim = TypeParam::value;
    for (const auto& law : immersedLaws) {
        const Immersed<Dim> s(law);
        const auto& [topology, constraints] = s.start;
        const auto& old = s.c.state.nodes;
        const auto& cells = s.c.state.mesh.fluid;
        const Step<Dim> step{s.c.problem, s.c.state.mesh, topology, constraints, old, {0.01}};
        const FluidPhase<Dim> phase(s.c.problem, s.c.state.mesh, topology.fluid, old, Integration::nodal);
        Nodes<Dim> end = old;
        end.v = s.velocities();
        end.p.assign(old.size(), 0.0);
        Nodes<Dim> still = old;
        still.p.assign(old.size(), 0.0);
        const auto R =
            continuityResidual<Dim>({s.c.problem, s.c.state.mesh, topology, constraints, still, {0.01}}, {}, phase,
                                    {PerCell<double>(cells.size(), 0.0), PerCell<unsigned char>(cells.size(), 0)},
                                    {end, end, {}, Vec<Dim>::Zero(), {}});
        const RiderColumns<Dim> columns(step, s.dofs, old.x);
        double most = 0;
        for (int i = 0; i < old.size(); ++i) {
            if (!topology.wet(i)) continue;
            std::map<int, Vec<Dim>> B;  // of i and its neighbours
            for (int slot = topology.fluid.start[i]; slot < topology.fluid.start[i + 1]; ++slot) {
                const auto& cell = cells.nodes[topology.fluid.cell[slot]];
                const auto g = simplexGeometry<Dim>(old.x, cell);
                for (int k = 0; k <= Dim; ++k) {
                    const auto place = B.emplace(cell[k], Vec<Dim>::Zero()).first;
                    place->second += g.measure / (Dim + 1) * g.gradN[k];
                }
            }
            std::vector<int> nodes;
            std::vector<Vec<Dim>> values;
            for (const auto& [node, value] : B) {
                nodes.push_back(node);
                values.push_back(value);
            }
            double sum = 0;
            for (const auto& [unknown, value] : columns.entries(i, nodes, values)) sum += value * s.U[unknown];
            EXPECT_NEAR(R[i], sum, 1e-13) << law << " " << i;
            most = std::max(most, std::abs(sum));
        }
        EXPECT_GT(most, 1e-4);
    }
}

}  // namespace
