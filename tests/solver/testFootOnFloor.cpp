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

/// Water that leans on a gate, which stands on the floor and is held at its top: clamped, or a rigid one by a hinge
/// over its wet side (one farther back would jam it).
template <int Dim>
CaseOf<Dim> gate(bool rigid) {
    const std::string hinge = Dim == 2 ? "centreOfRotation (0.1 0.14 0); constraints { hinge { type point; } }"
                                       : "centreOfRotation (0.1 0.03 0.14); constraints { hinge { type point; } about "
                                         "{ type axis; axis (0 1 0); } }";
    const std::string law = rigid ? "type rigid; " + hinge : "type hypoelastic; E 1e6; nu 0.4;";
    const std::string laws = water + "gate { rho 1100; " + law + " }";
    const std::string conditions = std::string("tank { type slip; } ") + (rigid ? "" : "top { type clamped; }");
    CaseOf<Dim> c;
    if constexpr (Dim == 2) {
        c = makeCase("meshSize 0.01; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.1, 0.14) +
                         " } gate { type solid; material gate; " + rectangle(0.1, 0, 0.12, 0.14) +
                         (rigid ? "" : " patches { top { edges ((2 3)); } }") +
                         " } ); walls ( tank { points ((0 0.3) (0 0) (1.2 0) (1.2 0.3)); } );",
                     laws, conditions);
    } else {
        c = onLattice(
            Vec<3>::Zero(), {0.12, 0.06, 0.14}, 0.02, [](const Vec<3>& x) { return x[0] < 0.1; },
            [](const Vec<3>& x) { return x[0] > 0.1; }, laws);
        c.state.mesh.patches.push_back(openBox(c.state, "tank", {1.2, 0.06, 0.3}));
        if (!rigid)
            c.state.mesh.patches.push_back(
                solidPatch(c.state, "top", [](const Vec<3>& x) { return x[2] > 0.14 - 1e-9; }));
        setConditions(c, conditions);
        std::vector<bool> isWall(c.state.mesh.patches.size(), false);
        isWall[0] = true;
        separateFromWalls<3>(isWall, c.state);
    }
    c.problem.contact = {true, 0.1};
    return c;
}

/// The solid's lowest nodes: the lowest place, and how far one has gone along.
template <int Dim>
std::pair<double, double> footOf(const CaseOf<Dim>& c) {
    const auto& nodes = c.state.nodes;
    double lowest = 1, gone = 0;
    for (const auto& cell : c.state.mesh.solid.nodes)
        for (const int i : cell) {
            lowest = std::min(lowest, nodes.x[i][Dim - 1]);
            if (nodes.X[i][Dim - 1] < 1e-9) gone = std::max(gone, nodes.x[i][0] - nodes.X[i][0]);
        }
    return {lowest, gone};
}

// The water opens it: the foot slides along the floor, on an edge where it bends, and off it where it turns.
TYPED_TEST(FootOnFloor, aGateOpens) {
    constexpr int Dim = TypeParam::value;
    for (const bool rigid : {false, true}) {
        auto c = gate<Dim>(rigid);
        c.start(5e-4);
        int rejected = 0;
        double deepest = 1;
        while (c.state.time.value < 0.05) {
            rejected += c.step(5e-4).rejected;
            deepest = std::min(deepest, footOf<Dim>(c).first);
        }
        const auto [lowest, gone] = footOf<Dim>(c);
        std::cout << Dim << "D " << (rigid ? "hinged" : "clamped") << ": foot by " << gone << " m, at " << lowest
                  << " m, deepest " << deepest << " m, " << rejected << " rejected\n";
        EXPECT_GT(gone, 1e-3);
        if (rigid) {
            EXPECT_GT(lowest, 1e-6);
        }
        EXPECT_GT(deepest, -1e-5);
        EXPECT_LE(rejected, 2);
    }
}

}  // namespace
