// Chords of bent walls: the flux taken from the continuity equation is the adjoint of the pressure taken from the
// momentum.

#include <gtest/gtest.h>

#include "momentum/bentWalls.hpp"
#include "support/bothDimensions.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

PFEM_BOTH_DIMENSIONS(BentWalls);

/// Water on a floor that is bent by some 8 degrees every 0.1 m (in space half of it), below the featureAngle, between
/// walls.
template <int Dim>
CaseOf<Dim> onABentFloor() {
    const auto floor = [](double x) { return 0.8 * x * x; };
    if constexpr (Dim == 2) {
        std::string bed;
        for (int k = 0; k <= 5; ++k) bed += "(" + std::to_string(0.1 * k) + " " + std::to_string(floor(0.1 * k)) + ") ";
        return makeCase("meshSize 0.05; bodies ( water { type fluid; material water; vertices (" + bed +
                            "(0.5 0.4) (0 0.4)); } ); walls ( tank { points ((0 0.5) " + bed + "(0.5 0.5)); } );",
                        water, "tank { type slip; }");
    } else {
        TestCase3 c;
        State<3>& state = c.state;
        state.mesh.materials = {"water"};
        addLattice(state, state.mesh.fluid, 0, {0, 0, 0}, {0.5, 0.2, 0.3}, 0.05);
        for (auto& x : state.nodes.x) x[2] += floor(x[0]) * (1 - x[2] / 0.5);
        Patch<3> tank{"tank", {}};
        const Vec<3> middle(0.25, 0.1, 0.4);
        for (int k = 0; k < 10; ++k) {  // nodes lie on the wall's points
            const double a = 0.05 * k, b = a + 0.05;
            addQuad(state, tank, {Vec<3>(a, 0, floor(a)), {b, 0, floor(b)}, {b, 0.2, floor(b)}, {a, 0.2, floor(a)}},
                    middle);
            for (const double y : {0.0, 0.2})
                addQuad(state, tank, {Vec<3>(a, y, floor(a)), {b, y, floor(b)}, {b, y, 0.5}, {a, y, 0.5}}, middle);
        }
        for (const double x : {0.0, 0.5})
            addQuad(state, tank, {Vec<3>(x, 0, floor(x)), {x, 0.2, floor(x)}, {x, 0.2, 0.5}, {x, 0, 0.5}}, middle);
        state.nodes.X = state.nodes.x;
        state.mesh.patches.push_back(tank);
        c.problem.materials = readMaterials(Dictionary::parse(water, "materials"));
        c.problem.conditions =
            readBoundaryConditions<3>(Dictionary::parse("tank { type slip; }", "conditions"), state.mesh.patches);
        separateFromWalls<3>({true}, state);
        return c;
    }
}

// p . (what subtractChordFlux takes for v) = v . (what addChordPressure takes for p), for velocities that the walls
// allow; and there is something to take.
TYPED_TEST(BentWalls, fluxIsTheTransposeOfThePressure) {
    constexpr int Dim = TypeParam::value;
    CaseOf<Dim> c = onABentFloor<Dim>();
    const auto topology = c.topology();
    const auto constraints = c.constraints(topology);
    Nodes<Dim> nodes = c.state.nodes;
    const int n = nodes.size();
    double most = 0;
    for (unsigned seed = 1; seed < 6; ++seed) {
        nodes.v = someVectors<Dim>(n, seed);
        nodes.p = randomNumbers(n, seed + 10);
        Points<Dim> force(n, Vec<Dim>::Zero());
        addChordPressure<Dim>(topology, nodes, force);
        std::vector<double> flux(n, 0.0);
        subtractChordFlux<Dim>(topology, constraints, nodes, flux);
        double power = 0;
        for (int i = 0; i < n; ++i) power += force[i].dot(constraints.project(i, nodes.v[i]));
        EXPECT_NEAR(dot(nodes.p, flux), power, 1e-14);
        most = std::max(most, std::abs(power));
    }
    EXPECT_GT(most, Dim == 2 ? 5e-4 : 2e-5);
}

// On straight walls and across edges that are concave nothing is taken.
TYPED_TEST(BentWalls, flatWallsHaveNoChords) {
    constexpr int Dim = TypeParam::value;
    CaseOf<Dim> c = [] {
        if constexpr (Dim == 2)
            return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.6, 0.3) +
                                " } ); walls ( tank { points ((0 0.5) (0 0) (0.6 0) (0.6 0.5)); } );",
                            water, "tank { type slip; }");
        else
            return boxOfWater({0.6, 0.4, 0.3}, {0.6, 0.4, 0.5}, 0.1);
    }();
    const auto topology = c.topology();
    c.state.nodes.v = someVectors<Dim>(c.state.nodes.size(), 3);
    c.state.nodes.p = randomNumbers(c.state.nodes.size(), 4);
    Points<Dim> force(c.state.nodes.size(), Vec<Dim>::Zero());
    addChordPressure<Dim>(topology, c.state.nodes, force);
    std::vector<double> flux(c.state.nodes.size(), 0.0);
    subtractChordFlux<Dim>(topology, c.constraints(topology), c.state.nodes, flux);
    // what remains at the edges of walls is not seen by velocities that the walls allow
    double power = 0;
    const auto constraints = c.constraints(topology);
    for (int i = 0; i < c.state.nodes.size(); ++i) power = std::max(power, constraints.project(i, force[i]).norm());
    EXPECT_LT(power, 1e-14);
    EXPECT_LT(largest(flux), 1e-14);
}

}  // namespace
