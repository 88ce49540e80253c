#include "functions/forces.hpp"

#include "base/error.hpp"
#include "caseFolder.hpp"
#include "functions/balance.hpp"
#include "momentum/mass.hpp"

namespace pfem {

using namespace test;

namespace {

constexpr double weight = 1000 * 10 * 0.5;  // of the tank's water [N/m]

/// Total, pressure, viscous: nine numbers behind the time.
std::vector<double> lastRow(const CaseFolder& folder, const std::string& file) { return folder.rows(file).back(); }

}  // namespace

// p = rho g (H - y): floor rho g H L downwards in its middle, sides rho g H^2/2 at H/3.
TEST(Forces, HydrostaticOnWalls) {
    const CaseFolder folder(water, tankConditions);
    auto functions = folder.functions(
        "floor { type forces; patches (floor); } right { type forces; patches (right); }"
        "all { type forces; patches (floor right left); CofR (0.5 0 0); }");
    functions.start(tank());
    const auto floor = lastRow(folder, "floor/0/force.dat");
    ASSERT_EQ(floor.size(), 10u);
    EXPECT_NEAR(floor[1], 0, 1e-9);
    EXPECT_NEAR(floor[2], -weight, 1e-6);
    EXPECT_NEAR(floor[5], -weight, 1e-6);
    EXPECT_NEAR(lastRow(folder, "floor/0/moment.dat")[3], -weight * 0.5, 1e-6);
    EXPECT_NEAR(lastRow(folder, "right/0/force.dat")[1], 1250, 1e-6);
    EXPECT_NEAR(lastRow(folder, "right/0/moment.dat")[3], -1250 * 0.5 / 3, 1e-6);
    EXPECT_NEAR(lastRow(folder, "all/0/force.dat")[1], 0, 1e-6);
    EXPECT_NEAR(lastRow(folder, "all/0/moment.dat")[3], 0, 1e-6);
}

// The same from the solver at rest, remeshed each step: 0.1 %.
TEST(Forces, ColumnAtRest) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                          water, "tank { type slip; }", {0, -10});
    c.start(1e-3);
    for (int k = 0; k < 20; ++k) c.step(1e-3);
    const FluidForce force = fluidForce<2>(c.problem, c.state, {0}, {});
    EXPECT_NEAR(force.pressure.force[0], 0, 1e-3 * weight);
    EXPECT_NEAR(force.pressure.force[1], -weight, 1e-3 * weight);
    EXPECT_NEAR(force.viscous.force.norm(), 0, 1e-6 * weight);
}

// v = (gamma y, 0): the floor is dragged along with mu gamma; a slip wall feels no shear.
TEST(Forces, ShearOnNoSlipWalls) {
    const CaseFolder folder("water { type newtonian; rho 1000; mu 3; kappa 2.1e9; }", tankConditions);
    auto functions =
        folder.functions("floor { type forces; patches (floor); } right { type forces; patches (right); }");
    State<2> state = tank();
    for (int i = 0; i < state.nodes.size(); ++i) state.nodes.v[i] = {20 * state.nodes.x[i][1], 0};
    functions.start(state);
    EXPECT_NEAR(lastRow(folder, "floor/0/force.dat")[7], 3 * 20 * 1.0, 1e-9);
    EXPECT_NEAR(lastRow(folder, "right/0/force.dat")[8], 0, 1e-9);
}

// A solid in water of constant pressure, weightless: p on each wetted face; the dry ones feel nothing.
TEST(Forces, OnASolidsWettedFace) {
    const CaseFolder folder(water + rubber, "base { type clamped; }", "(0 0 0)");
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 1) +
                              " } block { type solid; material rubber; " + rectangle(1, 0, 2, 0.5) +
                              " patches { base { edges ((1 2)); } } } );",
                          water + rubber, "base { type clamped; }");
    for (auto& p : c.state.nodes.p) p = 40;
    auto functions = folder.functions("block { type forces; solids (rubber); }");
    functions.start(c.state);
    EXPECT_NEAR(lastRow(folder, "block/0/force.dat")[1], 40 * 0.5, 1e-9);
    EXPECT_NEAR(lastRow(folder, "block/0/force.dat")[2], 0, 1e-9);
    EXPECT_NEAR(lastRow(folder, "block/0/moment.dat")[3], -40 * 0.5 * 0.25, 1e-9);
}

// Water sticks to a solid 2 cm above its level: the last face, 10 cm long, hangs on the solid with rho g 2 cm/6 each
// metre, upright to the face.
TEST(Forces, MeniscusHangsOnTheSolid) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 1) +
                              " pattern oneWay; } block { type solid; material rubber; " + rectangle(1, 0, 2, 2) +
                              " pattern oneWay; patches { base { edges ((1 2)); } } } );",
                          water + rubber, "base { type clamped; }", {0, -10});
    for (auto& x : c.state.nodes.x)
        if (x[0] < 0.999 && x[1] > 0.999) x[1] -= 0.02;
    const auto force = [&](const std::vector<int>& materials) {
        return fluidForce<2>(c.problem, c.state, {}, materials).pressure.force;
    };
    const int block = 1;
    ASSERT_EQ(c.state.mesh.materials[block], "rubber");
    EXPECT_NEAR(force({block})[1], -1000 * 10 * 0.02 / 6 * 0.1, 1e-9);
    EXPECT_NEAR(force({block})[0], 1000 * 10 * 0.02 / 6 * 0.02, 1e-9);
    EXPECT_EQ(force({0}).norm(), 0);
}

// Points of walls carry no fluid: how fast they are is no extreme of it.
TEST(Forces, ExtremesAreThoseOfBodies) {
    const CaseFolder folder(water, tankConditions);
    State<2> state = tank();
    const auto wet = nodesIn<2>(state.mesh.fluid.nodes, state.nodes.size());
    for (int i = 0; i < state.nodes.size(); ++i) state.nodes.v[i] = {wet[i] ? 3.0 : 50.0, 0};
    auto functions = folder.functions("m { type fieldMinMax; fields (U); }");
    functions.start(state);
    EXPECT_NE(folder.text("m/0/fieldMinMax.dat").find("\tU\t3\t"), std::string::npos);
    EXPECT_EQ(folder.text("m/0/fieldMinMax.dat").find("\t50\t"), std::string::npos);
}

// The support gives what the rest's inertia and weight ask for: sum m (a - g), here of a swinging beam.
TEST(Forces, ReactionBalancesWeightAndInertia) {
    for (const std::string integration : {"nodal", "elemental"}) {
        TestCase c = makeCase("meshSize 0.25; bodies ( beam { type solid; material rubber; " + rectangle(0, 0, 2, 0.5) +
                                  " pattern oneWay; patches { base { edges ((3 0)); } } } );",
                              rubber, "base { type clamped; }");
        c.controls.integration.integration = integration;
        c.tolerance(1e-9);
        c.start(1e-3);
        for (int k = 0; k < 60; ++k) c.step(2e-3);
        const auto mass = solidMass<2>(c.problem, c.state.mesh.solid, c.state.nodes.X);
        Vec<2> expected = Vec<2>::Zero();
        double total = 0;
        for (int i = 0; i < c.state.nodes.size(); ++i) {
            expected += mass[i] * (c.state.nodes.a[i] - c.problem.gravity);
            total += 9.81 * mass[i];
        }
        EXPECT_NEAR(total, 1500 * 9.81, 1e-6);
        const auto force = reaction<2>(c.problem, c.controls, c.state, {0});
        EXPECT_GT(std::abs(force.force[1] - total), 0.02 * total) << "it swings";
        EXPECT_NEAR(force.force[1], expected[1], 1e-4 * total);
        EXPECT_NEAR(force.force[0], expected[0], 1e-4 * total);
    }
}

// What moves freely is in balance: the forces are those of the step, friction at walls and panes and the damping of
// short waves included (backward Euler: at its end).
TEST(Forces, FreeNodesAreInBalance) {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
            " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
        water, "tank { type slip; friction 0.01; } panes { type sideWalls; width 0.2; friction 0.02; }", {0, -10});
    c.controls.timeIntegration.gamma = 1;
    c.tolerance(1e-10);
    for (int i = 0; i < c.state.nodes.size(); ++i) c.state.nodes.v[i] = {1 + 0.2 * std::sin(40.0 * i), 0};
    const auto topology = c.topology();
    const auto constraints = c.constraints(topology);
    c.state.nodes =
        fsiStep<2>({c.problem, c.state.mesh, topology, constraints, c.state.nodes, {1e-3, 1}}, c.controls).nodes;
    const auto forces = supportForces<2>(c.problem, c.controls, c.state);
    double worst = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) worst = std::max(worst, constraints.project(i, forces[i]).norm());
    const double friction = 0.5 * 1000 * 0.01 * 0.1;  // on one face of the floor, at 1 m/s
    EXPECT_LT(worst, 1e-5 * friction);
}

TEST(Forces, MistakesPrintTheValidWords) {
    const CaseFolder folder(water, tankConditions);
    EXPECT_THROW(folder.functions("f { type forces; }"), UserError);
    for (const auto& [text, word] : {std::pair{"patches (flor);", "floor"}, std::pair{"solids (steel);", "water"}}) {
        auto functions = folder.functions(std::string("f { type forces; ") + text + " }");
        try {
            functions.start(tank());
            ADD_FAILURE() << text;
        } catch (const UserError& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
}

}  // namespace pfem
