// Solids that stand on a wall at the start: their nodes are their own, the wall goes on under them, and the foot
// slides and leaves as contact says; rigid and elastic, in the plane and in space.

#include <gtest/gtest.h>

#include "support/bothDimensions.hpp"
#include "support/solids.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

const std::string stone = "stone { type rigid; rho 2000; }",
                  steel = "stone { type hypoelastic; rho 2000; E 1e7; nu 0.3; }";

/// A block on the floor, which both have nodes of at the same places.
template <int Dim>
CaseOf<Dim> standing(const std::string& law, double friction) {
    CaseOf<Dim> c;
    if constexpr (Dim == 2) {
        c = makeCase("meshSize 0.1; bodies ( block { type solid; material stone; " + rectangle(0.3, 0, 0.7, 0.2) +
                         " } ); walls ( floor { points ((-2 0) (4 0)); } );",
                     law, "floor { type slip; }");
    } else {
        c.state.mesh.materials = {"stone"};
        addLattice(c.state, c.state.mesh.solid, 0, {0.3, 0.3, 0}, {0.7, 0.6, 0.2}, 0.1);
        c.problem.materials = readMaterials(Dictionary::parse(law, "materials"));
        Patch<3> floor{"floor", {}};
        addQuad(c.state, floor, {Vec<3>(-2, -2, 0), Vec<3>(4, -2, 0), Vec<3>(4, 4, 0), Vec<3>(-2, 4, 0)}, {0, 0, 1});
        c.state.mesh.patches.push_back(floor);
        c.problem.conditions = readBoundaryConditions<3>(
            Dictionary::parse("floor { type slip; }", "boundaryConditions"), c.state.mesh.patches);
        separateFromWalls<3>({true}, c.state);
    }
    c.problem.contact = {true, friction};
    return c;
}

template <int Dim>
Vec<Dim> meanOfSolid(const CaseOf<Dim>& c, const Points<Dim>& value) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    int count = 0;
    for (const auto& cell : c.state.mesh.solid.nodes)
        for (const int i : cell) sum += value[i], ++count;
    return sum / count;
}

/// The mean acceleration over some time.
template <int Dim>
Vec<Dim> acceleration(CaseOf<Dim>& c, double dt, double time) {
    const double start = c.state.time.value;
    const Vec<Dim> before = meanOfSolid<Dim>(c, c.state.nodes.v);
    while (c.state.time.value < start + time - 0.5 * dt) EXPECT_EQ(c.step(dt).rejected, 0);
    return (meanOfSolid<Dim>(c, c.state.nodes.v) - before) / (c.state.time.value - start);
}

PFEM_BOTH_DIMENSIONS(FootOnFloor);

// Pushed by a gravity that leans, it slides with g_x - mu g_y or stands; with gravity upwards it flies.
TYPED_TEST(FootOnFloor, slidesAndLeaves) {
    constexpr int Dim = TypeParam::value;
    constexpr double mu = 0.3, g = 10;
    for (const auto& law : {stone, steel}) {
        const bool rigid = law == stone;
        const double dt = rigid ? 2e-3 : 5e-4, time = Dim == 2 ? 0.2 : 0.1;
        for (const double push : {2.0, 6.0}) {
            auto c = standing<Dim>(law, mu);
            c.problem.gravity.setZero();
            c.problem.gravity[0] = push;
            c.problem.gravity[Dim - 1] = -g;
            acceleration<Dim>(c, dt, 0.5 * time);  // an elastic one swings at first
            const double a = acceleration<Dim>(c, dt, time)[0], expected = std::max(0.0, push - mu * g);
            double lowest = 1;
            for (const auto& cell : c.state.mesh.solid.nodes)
                for (const int i : cell) lowest = std::min(lowest, c.state.nodes.x[i][Dim - 1]);
            std::cout << Dim << "D " << (rigid ? "rigid" : "elastic") << ", push " << push << ": acceleration " << a
                      << " (" << expected << "), lowest " << lowest << "\n";
            EXPECT_NEAR(a, expected, rigid ? 1e-6 * g : 0.005 * g);
            EXPECT_GT(lowest, -1e-4);
            c.problem.gravity[Dim - 1] = g;
            acceleration<Dim>(c, dt, 0.02);
            const Vec<Dim> up = acceleration<Dim>(c, dt, 0.05);
            const double swinging = rigid ? 1e-6 * g : 1e-3 * g;
            EXPECT_NEAR(up[Dim - 1], g, swinging);
            EXPECT_NEAR(up[0], push, swinging);
        }
    }
}

}  // namespace
