// The surface's last face at a place that it sticks to.

#include <gtest/gtest.h>

#include "momentum/meniscus.hpp"
#include "momentum/residual.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, rho = 1000;

PFEM_BOTH_DIMENSIONS(Meniscus);

/// Water, 0.5 m long and 0.4 m deep, beside an elastic wall of 0.2 x 0.6 m in a slippery tank.
template <int Dim>
CaseOf<Dim> atLevel() {
    if constexpr (Dim == 2) {
        return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.5, 0.4) +
                            " } wall { type solid; material rubber; " + rectangle(0.5, 0, 0.7, 0.6) +
                            " patches { base { edges ((0 1)); } } } );"
                            " walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                        water + rubber, "tank { type slip; } base { type clamped; }");
    } else {
        TestCase3 c = onLattice(
            Vec<3>::Zero(), {0.7, 0.3, 0.6}, 0.1, [](const Vec<3>& x) { return x[0] < 0.5 && x[2] < 0.4; },
            [](const Vec<3>& x) { return x[0] > 0.5; }, water + rubber);
        c.state.mesh.patches.push_back(openBox(c.state, "tank", {1, 0.3, 0.8}));
        setConditions(c, "tank { type slip; }");
        separateFromWalls<3>({true}, c.state);
        return c;
    }
}

/// The level is flat everywhere but at the wall, where it sticks `off` above it.
template <int Dim>
CaseOf<Dim> besideWall(double off) {
    CaseOf<Dim> c = atLevel<Dim>();
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.freeSurface[i] && topology.onSolid[i]) c.state.nodes.x[i][Dim - 1] += off;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        c.state.nodes.p[i] = topology.wet(i) ? rho * g * (0.4 - c.state.nodes.x[i][Dim - 1]) : 0;
    return c;
}

/// Residual of the fluid's momentum at rest, without what walls and solids bear.
template <int Dim>
Points<Dim> residual(const CaseOf<Dim>& c, bool meniscus) {
    const auto topology = c.topology();
    const auto& nodes = c.state.nodes;
    const FluidPhase<Dim> fluid(c.problem, c.state.mesh, topology.fluid, nodes, Integration::nodal);
    const SolidPhase<Dim> solid(c.problem, c.controls.solid, c.state.mesh, topology.solid, nodes, Integration::nodal);
    Points<Dim> external(nodes.size(), Vec<Dim>::Zero());
    if (meniscus) addMeniscus<Dim>(c.problem, c.state.mesh.fluid, topology, nodes, external);
    auto R = momentumResidual<Dim>(nodalMass<Dim>(fluid, solid), nodes, fluid, solid, external, 1);
    const auto constraints = c.constraints(topology);
    for (int i = 0; i < nodes.size(); ++i)
        R[i] = !topology.ofFluid(i) ? Vec<Dim>(Vec<Dim>::Zero()) : constraints.project(i, R[i]);
    return R;
}

// Hydrostatic pressure balances every free node exactly, wherever the surface sticks to the wall.
TYPED_TEST(Meniscus, hydrostaticPressureIsRest) {
    constexpr int Dim = TypeParam::value;
    const double weight = rho * g * std::pow(0.1, Dim), part = Dim == 2 ? 0.1 : 0.05;
    for (const double off : {-0.04, 0.02, 0.06}) {
        const CaseOf<Dim> c = besideWall<Dim>(off);
        EXPECT_LT(largest(residual<Dim>(c, true)), 1e-12 * weight) << off;
        EXPECT_GT(largest(residual<Dim>(c, false)), part * std::abs(off) / 0.1 * weight) << off;
    }
    EXPECT_LT(largest(residual<Dim>(besideWall<Dim>(0), false)), 1e-12 * weight);
}

// What hangs on the wall pulls at it: the force is within, and its work is that of a weight lifted to the wall.
TYPED_TEST(Meniscus, isAForceWithin) {
    constexpr int Dim = TypeParam::value;
    const CaseOf<Dim> c = besideWall<Dim>(0.03);
    const auto topology = c.topology();
    const auto& x = c.state.nodes.x;
    Points<Dim> force(c.state.nodes.size(), Vec<Dim>::Zero());
    addMeniscus<Dim>(c.problem, c.state.mesh.fluid, topology, c.state.nodes, force);
    Vec<Dim> sum = Vec<Dim>::Zero();
    double lifted = 0, expected = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        sum += force[i];
        if (topology.ofFluid(i)) lifted += force[i][Dim - 1];
    }
    EXPECT_LT(sum.norm(), 1e-12);
    for (const auto& face : topology.faces) {  // int N_J p dA of the nodes J that are free
        if (face.kind != FaceKind::freeSurface) continue;
        const auto held =
            std::count_if(face.nodes.begin(), face.nodes.end(), [&](int i) { return topology.onSolid[i]; });
        const double flat = std::abs(faceArea<Dim>(x, face.nodes)[Dim - 1]);
        expected += static_cast<double>(held * (Dim - held)) * rho * g * 0.03 * flat / (Dim * (Dim + 1));
    }
    EXPECT_GT(expected, 0.1 * rho * g * 0.03 * 0.1 * (Dim == 2 ? 1 : 0.3));
    EXPECT_NEAR(lifted, expected, 1e-9 * rho * g);

    Nodes<Dim> sunk = c.state.nodes;
    const double down = 1e-6;
    for (int i = 0; i < sunk.size(); ++i)
        if (topology.ofFluid(i)) sunk.x[i][Dim - 1] -= down;
    EXPECT_NEAR(meniscusWork<Dim>(c.problem, c.state.mesh.fluid, topology, c.state.nodes, sunk, 0.5), -lifted * down,
                1e-3 * lifted * down);
}

// A tongue that hangs far from its place is no meniscus: its pressure has a bound.
TYPED_TEST(Meniscus, isNoHigherThanTheMesh) {
    constexpr int Dim = TypeParam::value;
    const CaseOf<Dim> c = besideWall<Dim>(0.15);
    const auto topology = c.topology();
    double most = 0;
    for (const auto& face : topology.faces)
        if (face.kind == FaceKind::freeSurface)
            for (const double p : meniscusPressure<Dim>(c.problem, rho, topology, c.state.nodes, face.nodes))
                most = std::max(most, std::abs(p));
    EXPECT_NEAR(most, rho * g * 0.1, 1e-9 * rho * g);
}

}  // namespace
