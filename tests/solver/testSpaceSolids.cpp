// Solids in three dimensions: a block that tumbles freely, water on an elastic column.

#include <gtest/gtest.h>

#include <cstdlib>

#include "functions/storedEnergy.hpp"
#include "mesher/space/readSpaceDict.hpp"
#include "mesher/space/spaceMesher.hpp"
#include "momentum/mass.hpp"
#include "solver/checkProblem.hpp"
#include "support/bothDimensions.hpp"
#include "walls/penetration.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A free block with sides of 3 : 2 : 1 that turns about its middle axis, a little off it.
TestCase3 spinningBlock(double turnsPerSecond, const std::string& law) {
    TestCase3 c = onLattice(
        {-0.15, -0.1, -0.05}, {0.15, 0.1, 0.05}, 0.1, [](const Vec<3>&) { return false; },
        [](const Vec<3>&) { return true; }, water + "rubber { type " + law + "; rho 1200; E 1e6; nu 0.3; }");
    shake<3>(0.012, c.state.nodes);
    c.problem.gravity.setZero();
    const Vec<3> omega = 2 * M_PI * turnsPerSecond * Vec<3>(0.03, 1, 0.02);
    for (int i = 0; i < c.state.nodes.size(); ++i)
        c.state.nodes.v[i] = omega.cross(c.state.nodes.x[i]) + Vec<3>(0.1, -0.2, 0.3);
    return c;
}

/// About the centre of mass.
struct Motion {
    Vec<3> momentum = Vec<3>::Zero(), spin = Vec<3>::Zero();
    Vec<3> halfAStepOn = Vec<3>::Zero();  // spin of x + dt/2 v and v + dt/2 a
    double energy = 0;
};

Motion motionOf(const TestCase3& c, double dt) {
    Motion m;
    const auto& nodes = c.state.nodes;
    const auto mass = solidMass<3>(c.problem, c.state.mesh.solid, nodes.X);
    Vec<3> centre = Vec<3>::Zero();
    double total = 0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        total += mass[i];
        centre += mass[i] * nodes.x[i];
        m.momentum += mass[i] * nodes.v[i];
    }
    centre /= total;
    const Vec<3> drift = m.momentum / total;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const Vec<3> x = nodes.x[i] - centre, v = nodes.v[i] - drift;
        m.spin += mass[i] * x.cross(v);
        m.halfAStepOn += mass[i] * Vec<3>(x + 0.5 * dt * v).cross(Vec<3>(v + 0.5 * dt * nodes.a[i]));
        m.energy += 0.5 * mass[i] * v.squaredNorm();
    }
    m.energy += elasticEnergy<3>(c.problem, c.controls, c.state);
    return m;
}

/// The block's middle axis, as it has turned.
Vec<3> middleAxis(const TestCase3& c) {
    Vec<3> axis = Vec<3>::Zero();
    for (int i = 0; i < c.state.nodes.size(); ++i) axis += c.state.nodes.X[i][1] * c.state.nodes.x[i];
    return axis.normalized();
}

class Tumbling : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

// Turning about the middle axis is unstable: the block turns over, again and again. Momentum and energy stay what they
// are. The trapezoidal rule of solids is the midpoint rule of X = x + dt/2 v and V = v + dt/2 a:
//     X' - X = dt v' = dt (V + V')/2,   V' - V = dt a' = dt f(x')/m,   x' = (X + X')/2
// which keeps sum m X x V, whatever the step, for f has no moment about x'. As sum m x x a = 0, that is
//     sum m x x v + dt^2/4 sum m v x a:
// the angular momentum of x and v swings about it by (omega dt)^2/4 without drift, and is kept within 1e-6 with steps
// of 1/4000 of a turn (PFEM_LONG_TESTS).
TEST_P(Tumbling, keepsItsAngularMomentumAndEnergy) {
    const auto [law, integration] = GetParam();
    TestCase3 c = spinningBlock(1, law);
    c.controls.integration.integration = integration;
    c.tolerance(1e-9);
    const bool fine = std::getenv("PFEM_LONG_TESTS") != nullptr;
    const int perTurn = fine ? 5000 : 250;
    const double dt = 1.0 / perTurn, swing = std::pow(2 * M_PI * dt, 2) / 4;
    c.start(dt);
    const Motion first = motionOf(c, dt);
    double spin = 0, shifted = 0, energy = 0, momentum = 0, over = 1;
    for (int n = 0; n < 10 * perTurn; ++n) {
        ASSERT_EQ(c.step(dt).rejected, 0);
        const Motion now = motionOf(c, dt);
        spin = std::max(spin, (now.spin - first.spin).norm() / first.spin.norm());
        shifted = std::max(shifted, (now.halfAStepOn - first.halfAStepOn).norm() / first.spin.norm());
        energy = std::max(energy, std::abs(now.energy / first.energy - 1));
        momentum = std::max(momentum, (now.momentum - first.momentum).norm() / first.momentum.norm());
        over = std::min(over, middleAxis(c).dot(first.spin.normalized()));
    }
    std::cout << law << " " << integration << ": angular momentum " << shifted << " (of x and v " << spin
              << "), energy " << energy << ", momentum " << momentum << ", middle axis at " << over << "\n";
    EXPECT_LT(shifted, 1e-6);
    EXPECT_LT(spin, fine ? 1e-6 : 4 * swing);
    EXPECT_LT(energy, 1e-3);
    EXPECT_LT(momentum, 1e-9);
    EXPECT_LT(over, -0.9);
}

INSTANTIATE_TEST_SUITE_P(, Tumbling,
                         testing::Values(std::tuple("hypoelastic", "nodal"), std::tuple("hypoelastic", "elemental"),
                                         std::tuple("neoHookean", "nodal")),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param);
                         });

/// 0.05 x 0.05 m, solid 0 ... 0.25 m clamped at its base, water up to 1 m, between slippery walls: as
/// testElasticColumn.cpp, with less gravity, so that strains are small. The mesh is pfemMesh's: on a lattice the
/// triangulation of the water may take the other diagonals of the solid's squares.
TestCase3 column(double gravity, const std::string& h) {
    TestCase3 c;
    const auto description = readSpaceDict(
        Dictionary::parse("dimension 3; meshSize " + h +
                              "; bodies { solid { type solid; material solid; geometry { type box; min (0 0 0); max "
                              "(0.05 0.05 0.25); } patches { base { faces zMin; } sides { faces (xMin xMax yMin yMax); "
                              "} } } water { type fluid; material water; geometry { type box; min (0 0 0.25); max "
                              "(0.05 0.05 1); } } } walls { tank { geometry { type box; min (0 0 0); max (0.05 0.05 "
                              "1.2); } open (zMin zMax); } }",
                          "meshDict"),
        {"water", "solid"}, "");
    c.state = buildSpaceMesh(description).state;
    const auto all =
        readMaterials(Dictionary::parse("water { type newtonian; rho 1000; mu 0; kappa 2.1e9; }"
                                        "solid { type hypoelastic; rho 1500; E 2.3e5; nu 0.4; }",
                                        "materials"));
    for (const auto& name : c.state.mesh.materials) c.problem.materials.push_back(findMaterial(all, name));
    c.problem.conditions = readBoundaryConditions<3>(
        Dictionary::parse("base { type clamped; } sides { type symmetry; } tank { type slip; }", "conditions"),
        c.state.mesh.patches);
    c.problem.gravity = {0, 0, -gravity};
    return c;
}

class ElasticColumnInSpace : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

// Rod with an end mass: beta tan beta = rho_s h_s/(rho_f h_f); u = -0.47554e-3 g (1 - cos(2 pi t/0.13265 s)).
TEST_P(ElasticColumnInSpace, waterOnItIsItsMass) {
    const auto [integration, h] = GetParam();
    const double g = 0.5;
    TestCase3 c = column(g, h);
    c.controls.integration.integration = integration;
    c.controls.continuity.volumeCorrectionTime = 0;
    c.tolerance(1e-7);
    const double dt = 1e-3;
    c.start(dt);
    std::vector<Id> top;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (std::abs(c.state.nodes.X[i][2] - 0.25) < 1e-9) top.push_back(c.state.nodes.id[i]);
    ASSERT_GT(top.size(), 6u);
    std::vector<double> t, u, mean(top.size(), 0.0);
    for (int n = 0; n < 300; ++n) {
        ASSERT_EQ(c.step(dt).rejected, 0);
        const auto& nodes = c.state.nodes;
        t.push_back(c.state.time.value);
        u.push_back(0);
        for (std::size_t k = 0; k < top.size(); ++k) {
            const auto i = std::find(nodes.id.begin(), nodes.id.end(), top[k]) - nodes.id.begin();
            const double w = nodes.x[i][2] - nodes.X[i][2];
            u.back() += w / static_cast<double>(top.size());
            mean[k] += w / 300;
        }
    }
    const auto fit = fitHarmonic(t, u, 35, 60);
    const double period = 2 * M_PI / fit.omega, lowest = *std::min_element(u.begin(), u.end()), sag = -4.7554e-4 * g;
    const double spread = *std::max_element(mean.begin(), mean.end()) - *std::min_element(mean.begin(), mean.end());
    std::cout << integration << ": period " << period / 0.13265 << ", mean " << fit.mean / sag << ", peak "
              << lowest / (2 * sag) << " of the closed form, means differ by " << spread / std::abs(sag)
              << " of it over the width\n";
    EXPECT_NEAR(period, 0.13265, 0.01 * 0.13265);
    EXPECT_NEAR(fit.mean, sag, 0.01 * std::abs(sag));
    EXPECT_NEAR(lowest, 2 * sag, 0.01 * std::abs(2 * sag));
    EXPECT_LT(spread, 0.05 * std::abs(sag));  // no edge of the column hangs on the walls
    EXPECT_NEAR(*std::min_element(u.end() - 140, u.end()), lowest, 0.012 * std::abs(lowest));  // no damping
}

INSTANTIATE_TEST_SUITE_P(, ElasticColumnInSpace,
                         testing::Values(std::tuple("nodal", "0.016"), std::tuple("elemental", "0.02")),
                         [](const auto& test) { return std::string(std::get<0>(test.param)); });

// No constraint holds the solid's faces in the triangulation: water that comes through one that it covers goes, for put
// back it would come through again. Water that arrives is put back alone.
TEST(ColumnInSpace, waterThatComesThroughItsFaceIsTold) {
    for (const bool arrives : {false, true}) {
        TestCase3 c = column(1, "0.016");
        const auto topology = c.topology();
        const Vec<3> place(0.025, 0.025, arrives ? 0.6 : 0.262);
        int i = -1;
        for (int j = 0; j < c.state.nodes.size(); ++j) {
            const auto& x = c.state.nodes.x;
            if (!topology.wet(j) || topology.onSolid[j] || topology.onWall[j]) continue;
            if (i < 0 || (x[j] - place).norm() < (x[i] - place).norm()) i = j;
        }
        ASSERT_GE(i, 0);
        c.state.nodes.x[i][2] = 0.249;
        const auto returned = returnPenetrating<3>(topology, 0.05, c.state);
        EXPECT_EQ(returned.number, 1);
        EXPECT_EQ(returned.behind, arrives ? std::vector<int>{} : std::vector<int>{i});
        EXPECT_NEAR(c.state.nodes.x[i][2], 0.25 + 0.05 * c.state.nodes.h[i], 1e-9);
    }
}

// The fluid's faces change with each triangulation: a plane of symmetry of its own would become a free surface.
TEST(ColumnInSpace, planesOfSymmetryAreOfSolids) {
    TestCase3 c = column(1, "0.025");
    const auto check = [&] {
        checkConditions<3>(
            Dictionary::parse("sides { type symmetry; } base { type clamped; } tank { type slip; }", "conditions"),
            c.problem.conditions, c.state);
    };
    EXPECT_NO_THROW(check());
    const auto& fluid = c.state.mesh.fluid.nodes;
    const auto find = [&](const std::string& name) -> Patch<3>& {
        return *std::find_if(c.state.mesh.patches.begin(), c.state.mesh.patches.end(),
                             [&](const auto& patch) { return patch.name == name; });
    };
    find("sides").faces.push_back(boundaryFaces<3>(fluid, nodeToCells<3>(fluid, c.state.nodes.size())).back().nodes);
    try {
        check();
        ADD_FAILURE();
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("'sides' is not on a solid alone"), std::string::npos) << error.what();
    }
}

}  // namespace
