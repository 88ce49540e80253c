// The surface's last face at a place that it sticks to.

#include <gtest/gtest.h>

#include "momentum/meniscus.hpp"
#include "momentum/residual.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, rho = 1000;

/// Water beside an elastic wall; its level everywhere but at the wall, where it sticks `off` above it.
TestCase besideWall(double off) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.5, 0.4) +
                              " } wall { type solid; material rubber; " + rectangle(0.5, 0, 0.7, 0.6) +
                              " patches { base { edges ((0 1)); } } } );"
                              " walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                          water + rubber, "tank { type slip; } base { type clamped; }");
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.freeSurface[i] && topology.onSolid[i]) c.state.nodes.x[i][1] += off;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        c.state.nodes.p[i] = topology.wet(i) ? rho * g * (0.4 - c.state.nodes.x[i][1]) : 0;
    return c;
}

/// Residual of the fluid's momentum at rest, without what walls and solids bear.
Points<2> residual(const TestCase& c, bool meniscus) {
    const auto topology = c.topology();
    const auto& nodes = c.state.nodes;
    const FluidPhase<2> fluid(c.problem, c.state.mesh, topology.fluid, nodes, Integration::nodal);
    const SolidPhase<2> solid(c.problem, c.controls.solid, c.state.mesh, topology.solid, nodes, Integration::nodal);
    Points<2> external(nodes.size(), Vec<2>::Zero());
    if (meniscus) addMeniscus<2>(c.problem, c.state.mesh.fluid, topology, nodes, external);
    auto R = momentumResidual<2>(nodalMass<2>(fluid, solid), nodes, fluid, solid, external, 1);
    const auto constraints = c.constraints(topology);
    for (int i = 0; i < nodes.size(); ++i)
        R[i] = !topology.ofFluid(i) ? Vec<2>(0, 0) : Vec<2>(constraints.project(i, R[i]));
    return R;
}

// Hydrostatic pressure balances every free node exactly, wherever the surface sticks to the wall.
TEST(Meniscus, hydrostaticPressureIsRest) {
    const double weight = rho * g * 0.1 * 0.1;
    for (const double off : {-0.04, 0.02, 0.06}) {
        const TestCase c = besideWall(off);
        EXPECT_LT(largest(residual(c, true)), 1e-12 * weight) << off;
        EXPECT_GT(largest(residual(c, false)), 0.1 * std::abs(off) / 0.1 * weight) << off;
    }
    EXPECT_LT(largest(residual(besideWall(0), false)), 1e-12 * weight);
}

// What hangs on the wall pulls at it: the force is within, and its work is that of a weight lifted to the wall.
TEST(Meniscus, isAForceWithin) {
    const TestCase c = besideWall(0.03);
    const auto topology = c.topology();
    Points<2> force(c.state.nodes.size(), Vec<2>::Zero());
    addMeniscus<2>(c.problem, c.state.mesh.fluid, topology, c.state.nodes, force);
    Vec<2> sum = Vec<2>::Zero();
    double lifted = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        sum += force[i];
        if (topology.ofFluid(i)) lifted += force[i][1];
    }
    EXPECT_LT(sum.norm(), 1e-12);
    double width = 0;
    for (const auto& face : topology.faces)
        if (face.kind == FaceKind::freeSurface && topology.onSolid[face.nodes[0]] != topology.onSolid[face.nodes[1]])
            width = std::abs(c.state.nodes.x[face.nodes[0]][0] - c.state.nodes.x[face.nodes[1]][0]);
    EXPECT_NEAR(lifted, rho * g * 0.03 * width / 6, 1e-9 * rho * g);

    Nodes<2> sunk = c.state.nodes;
    const double down = 1e-6;
    for (int i = 0; i < sunk.size(); ++i)
        if (topology.ofFluid(i)) sunk.x[i][1] -= down;
    EXPECT_NEAR(meniscusWork<2>(c.problem, c.state.mesh.fluid, topology, c.state.nodes, sunk, 0.5), -lifted * down,
                1e-3 * lifted * down);
}

// A tongue that hangs far from its place is no meniscus: its pressure has a bound.
TEST(Meniscus, isNoHigherThanTheMesh) {
    const TestCase c = besideWall(0.15);
    const auto topology = c.topology();
    double most = 0;
    for (const auto& face : topology.faces)
        if (face.kind == FaceKind::freeSurface)
            for (const double p : meniscusPressure<2>(c.problem, rho, topology, c.state.nodes, face.nodes))
                most = std::max(most, std::abs(p));
    EXPECT_NEAR(most, rho * g * 0.1, 1e-9 * rho * g);
}

}  // namespace
