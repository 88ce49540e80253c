#include "functions/energy.hpp"

#include "caseFolder.hpp"
#include "io/stateFiles.hpp"
#include "solver/fluidEnergy.hpp"
#include "support/cantilever.hpp"

namespace pfem {

using namespace test;

namespace {

enum Column {
    time,
    kinetic,
    elastic,
    potential,
    total,
    viscous,
    damper,
    workWalls,
    workLoads,
    remeshing,
    volume,
    numerical
};

/// Advance with the function watching.
void run(TestCase& c, FunctionObjects<2>& functions, double dt, int steps) {
    for (int k = 0; k < steps; ++k) {
        c.step(dt);
        functions.execute(c.state);
        c.state.memory = functions.memory();
    }
}

}  // namespace

// Kinetic + elastic + dissipation = work of the load, within 1 % of the peak elastic energy at every step.
TEST(Energy, ClosesOnTheCantilever) {
    const CaseFolder folder("steel { type hypoelastic; rho 1; E 1e4; nu 0.25; }",
                            "base { type clamped; } end { type traction; traction (0 10 0); }", "(0 0 0)");
    TestCase c = cantilever("(25 4)", "checkerboard", "nodal", "rotatedMidpoint", 0.1);
    c.start(0.05);
    auto functions = folder.functions("energy { type energy; }");
    functions.start(c.state);
    run(c, functions, 0.05, 110);
    double peak = 0, worst = 0;
    const auto rows = folder.rows("energy/0/energy.dat");
    ASSERT_EQ(rows.size(), 111u);
    for (const auto& row : rows) {
        peak = std::max(peak, row[elastic]);
        worst = std::max(worst, std::abs(row[numerical]));
        EXPECT_NEAR(row[kinetic] + row[elastic] + row[damper] + row[numerical], row[workLoads],
                    1e-6 * (1 + row[workLoads]));
    }
    std::cout << "peak elastic energy " << peak << ", largest error of the balance " << worst << "\n";
    EXPECT_GT(peak, 100);
    EXPECT_LT(worst, 0.01 * peak);
    EXPECT_GT(rows.back()[damper], 0);
    EXPECT_GT(rows.back()[workLoads], 0.5 * peak);
}

TEST(Energy, NumericalDissipationFallsWithMeshAndStep) {
    // a tilted surface that swings back, in parts of the energy of the tilt, rho g a^2 L/6
    const auto lost = [](double h, double dt, double gamma, double returnTime) {
        TestCase c =
            makeCase("meshSize " + std::to_string(h) +
                         "; bodies ( water { type fluid; material water; vertices ((0 0) (1 0) (1 0.48) (0 0.52)); } );"
                         " walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                     water, "tank { type slip; }");
        c.controls.timeIntegration.gamma = gamma;
        c.controls.continuity.volumeReturnTime = returnTime;
        c.start(dt);
        const double first = storedEnergy<2>(c.problem, c.controls, c.state).total();
        while (c.state.time.value < 0.6 - 0.5 * dt) c.step(dt);
        return (first - storedEnergy<2>(c.problem, c.controls, c.state).total()) / (1000 * 9.81 * 0.02 * 0.02 / 6);
    };
    const double coarse = lost(0.1, 0.01, 0.5, 0.02), fine = lost(0.05, 0.01, 0.5, 0.02);
    // without the return of lost volume, which lifts the surface and so feeds energy
    const double slow = lost(0.1, 0.02, 1, 0), quick = lost(0.1, 0.01, 1, 0);
    std::cout << "trapezoidal, h 0.1 / 0.05: " << coarse << " / " << fine
              << ", backward Euler, dt 0.02 / 0.01: " << slow << " / " << quick << "\n";
    EXPECT_LT(std::abs(fine), 0.6 * std::abs(coarse));
    EXPECT_NEAR(quick / slow, 0.55, 0.1);
}

// A column that falls on its own tongue's bed: contacts take energy, whatever the step; what is left falls with it.
TEST(Energy, RemeshingAndVolumeStandApart) {
    const CaseFolder folder(water, "tank { type slip; }");
    const auto run = [&](double dt) {
        TestCase c = makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.5, 1) +
                                  " } ); walls ( tank { points ((0 2) (0 0) (1.2 0) (1.2 2)); } );",
                              water, "tank { type slip; }");
        c.start(dt);
        const double first = storedEnergy<2>(c.problem, c.controls, c.state).total();
        while (c.state.time.value < 0.5 - 0.5 * dt) c.step(dt);
        const double lost = first - storedEnergy<2>(c.problem, c.controls, c.state).total();
        const double apart = c.state.energy[EnergyCause::remeshing] + c.state.energy[EnergyCause::volume];
        return std::pair(apart, lost + apart);  // the latter without viscosity, which is small
    };
    const auto [apartLong, numericalLong] = run(4e-3);
    const auto [apartShort, numericalShort] = run(1e-3);
    std::cout << "steps of 4 / 1 ms: remeshing and volume " << apartLong << " / " << apartShort << ", numerical "
              << numericalLong << " / " << numericalShort << " J/m\n";
    EXPECT_GT(numericalShort, 0);
    EXPECT_LT(numericalShort, 0.7 * numericalLong);
    EXPECT_LT(numericalShort, 0.01 * 1000 * 9.81 * 0.5 * 0.5);  // of the column's energy
}

// The energy of water that appears: where nothing moves rho (v^2/2 - g . x) of the added volume, and p of what is asked
// for.
TEST(Energy, OfAddedVolume) {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 2, 1, 3) + " } );", water, "");
    c.problem.gravity = {0, -10};
    Nodes<2> old = c.state.nodes, now = c.state.nodes;
    for (int i = 0; i < now.size(); ++i) {
        old.v[i] = now.v[i] = {3, 4};
        now.p[i] = 2.1e6;
        now.x[i][0] *= 1.01;  // 0.01 m2, with its centre at a height of 2.5 m
    }
    const std::vector<double> nothing(now.size(), 0.0);
    std::vector<double> asked = nothing;
    asked[0] = 0.004;
    const double added = volumeEnergy<2>(c.problem, c.state.mesh.fluid, old, now, nothing);
    EXPECT_NEAR(added, 1000 * 0.01 * (12.5 + 10 * 2.5), 1e-9);
    EXPECT_NEAR(volumeEnergy<2>(c.problem, c.state.mesh.fluid, old, now, asked) - added, 2.1e6 * 0.004, 1e-6);
    c.state.nodes = now;
    const auto stored = fluidEnergy<2>(c.problem, c.state);
    EXPECT_NEAR(stored.kinetic, 1010 * 12.5, 1e-6);
    EXPECT_NEAR(stored.potential, 1010 * 10 * 2.5, 1e-6);
    EXPECT_NEAR(stored.elastic, 1.01 * 0.5 * 2.1e6 * 1e-3, 1e-6);  // p/kappa = 1e-3
    const auto drop = static_cast<std::size_t>(now.size() - 1);
    c.state.nodes.dropVolume[drop] = 0.1;
    EXPECT_NEAR(fluidEnergy<2>(c.problem, c.state).total() - stored.total(), 100 * (12.5 + 10 * now.x[drop][1]), 1e-6);
}

// A block of water in free fall: nothing is dissipated, potential becomes kinetic.
TEST(Energy, FreeFall) {
    const CaseFolder folder(water, "floor { type slip; }");
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 1, 0.5, 1.5) +
                              " } ); walls ( floor { points ((-1 0) (2 0)); } );",
                          water, "floor { type slip; }", {0, -10});
    c.start(1e-2);
    auto functions = folder.functions("energy { type energy; }");
    functions.start(c.state);
    run(c, functions, 1e-2, 20);
    const auto rows = folder.rows("energy/0/energy.dat");
    EXPECT_NEAR(rows.front()[potential], 250 * 10 * 1.25, 1e-6);
    EXPECT_NEAR(rows.back()[kinetic], 0.5 * 250 * 4, 1e-6);  // v = 10 * 0.2
    EXPECT_NEAR(rows.back()[numerical], 0, 1e-6);
    EXPECT_NEAR(rows.back()[remeshing], 0, 1e-9);
}

// A block of water without gravity, seen from a box that gets faster by 2 m/s2 to the left: what it gets faster by
// works like a load, 250 kg 2 m/s2 0.4 m.
TEST(Energy, OfAFrameThatGetsFaster) {
    const std::string V = "polynomial (((-2 0 0) (1 1 1)));";
    const CaseFolder folder(water, "", "(0 0 0); frameVelocity " + V);
    TestCase c =
        makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 1, 0.5, 1.5) + " } );",
                 water, "", {0, 0});
    c.problem.frameOverTime = readFunction1<Eigen::Vector3d>(Dictionary::parse("V " + V), "V");
    c.start(2e-2);
    auto functions = folder.functions("energy { type energy; }");
    functions.start(c.state);
    run(c, functions, 2e-2, 10);
    const auto last = folder.rows("energy/0/energy.dat").back();
    EXPECT_NEAR(last[kinetic], 0.5 * 250 * 0.16, 1e-6);
    EXPECT_NEAR(last[workLoads], 20, 1e-6);
    EXPECT_EQ(last[potential], 0);
    EXPECT_NEAR(last[numerical], 0, 1e-6);
}

// v = (gamma y, 0) dissipates mu gamma^2 per volume; a wall that recedes with v takes p v per length.
TEST(Energy, Powers) {
    TestCase c =
        makeCase("meshSize 0.1; bodies ( water { type fluid; material oil; " + rectangle(0, 0, 1, 0.5) +
                     " } ); walls ( floor { points ((0 0) (1 0)); } right { points ((1 0) (1 1)); } );",
                 "oil { type newtonian; rho 1000; mu 3; kappa 2.1e9; }", "floor { type slip; } right { type slip; }");
    for (int i = 0; i < c.state.nodes.size(); ++i) c.state.nodes.v[i] = {20 * c.state.nodes.x[i][1], 0};
    EXPECT_NEAR(energyPowers<2>(c.problem, c.controls, c.state).viscous, 3 * 400 * 0.5, 1e-9);
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        c.state.nodes.v[i] = {2, 0};
        c.state.nodes.p[i] = 70;
    }
    EXPECT_NEAR(energyPowers<2>(c.problem, c.controls, c.state).walls, -70 * 2 * 0.5, 1e-9);
    EXPECT_NEAR(storedEnergy<2>(c.problem, c.controls, c.state).kinetic, 0.5 * 500 * 4, 1e-9);
}

// What was dissipated before a restart is not forgotten: the same rows to the last digit.
TEST(Energy, GoesOnAfterARestart) {
    const CaseFolder folder("steel { type hypoelastic; rho 1; E 1e4; nu 0.25; }",
                            "base { type clamped; } end { type traction; traction (0 10 0); }", "(0 0 0)");
    TestCase c = cantilever("(13 2)", "oneWay", "nodal", "rotatedMidpoint", 0.1);
    c.start(0.05);
    auto functions = folder.functions("energy { type energy; }");
    functions.start(c.state);
    run(c, functions, 0.05, 6);
    writeState(folder.path() / "0.3", c.state);
    run(c, functions, 0.05, 6);
    const auto whole = folder.rows("energy/0/energy.dat");
    c.state = readState<2>(folder.path() / "0.3");
    auto again = folder.functions("energy { type energy; }", "0.3");
    again.start(c.state);
    run(c, again, 0.05, 6);
    const auto rest = folder.rows("energy/0.3/energy.dat");
    ASSERT_EQ(rest.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(rest[k], whole[k + 7]);
}

}  // namespace pfem
