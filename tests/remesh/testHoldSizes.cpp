// Sizes that belong to places: what each node gets, and the tree that finds it.

#include <gtest/gtest.h>

#include <random>

#include "mesh/distance.hpp"
#include "remesh/holdSizes.hpp"
#include "remesh/sizeTree.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

const std::string tankMesh = "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 1) +
                             " } %BODIES ); walls ( gate { points ((1 0) (1 1)); %GATE } );";

TestCase tankWith(const std::string& more, const std::string& bodies = "", const std::string& gate = "") {
    std::string mesh = tankMesh;
    mesh.replace(mesh.find("%BODIES"), 7, bodies);
    mesh.replace(mesh.find("%GATE"), 5, gate);
    return makeCase(mesh + " holdSizes yes; " + more, water + rubber, "gate { type slip; }");
}

/// The sizes that nodes of the fluid get are those of `wanted`, whatever they had.
template <class Wanted>
void expectSizes(TestCase& c, const Wanted& wanted) {
    for (auto& h : c.state.nodes.h) h *= 1.1;
    const auto topology = c.topology();
    const auto before = c.state.nodes.h;
    holdSizes<2>(topology, c.problem.period, c.state);
    int finer = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const double h = topology.ofFluid(i) && !topology.onSolid[i] ? wanted(c.state.nodes.x[i]) : before[i];
        EXPECT_NEAR(c.state.nodes.h[i], h, 1e-12);
        finer += h < 0.09;
    }
    EXPECT_GT(finer, 5);
}

double beyond(double distance) { return std::min(0.1, 0.04 + 0.2 * std::max(0.0, distance)); }

TEST(HoldSizes, boxSphereAndCurve) {
    TestCase box = tankWith("refinements { a { type box; min (0.4 0.4); max (0.6 0.5); meshSize 0.04; } }");
    expectSizes(box, [](const Vec<2>& x) { return beyond(distanceToBox<2>(x, {0.4, 0.4}, {0.6, 0.5})); });
    TestCase sphere = tankWith("refinements { a { type sphere; centre (0.5 0.3); radius 0.1; meshSize 0.04; } }");
    expectSizes(sphere, [](const Vec<2>& x) { return beyond((x - Vec<2>(0.5, 0.3)).norm() - 0.1); });
    TestCase curve =
        tankWith("refinements { a { type curve; points ((0 0.5) (0.5 0.5) (1 0)); distance 0.05; meshSize 0.04; } }");
    expectSizes(curve, [](const Vec<2>& x) {
        return beyond(
            std::min(distanceToSegment<2>({0, 0.5}, {0.5, 0.5}, x), distanceToSegment<2>({0.5, 0.5}, {1, 0}, x)) -
            0.05);
    });
}

TEST(HoldSizes, wallsAndSolidsCarryTheirs) {
    TestCase gate = tankWith("", "", "meshSize 0.04;");
    for (const auto& face : gate.state.mesh.patches[0].faces)
        for (const int i : face) gate.state.nodes.x[i][0] = 0.8;
    expectSizes(gate, [](const Vec<2>& x) { return beyond(std::abs(x[0] - 0.8)); });
    TestCase solid =
        tankWith("", "wall { type solid; material rubber; meshSize 0.04; " + rectangle(-0.2, 0, 0, 1) + "}");
    for (auto& h : solid.state.nodes.h) h /= 1.1;  // of the solid, too
    const auto topology = solid.topology();
    for (int i = 0; i < solid.state.nodes.size(); ++i)
        if (topology.onSolid[i]) solid.state.nodes.h[i] = 0.04 / 1.1;
    expectSizes(solid, [](const Vec<2>& x) { return beyond(x[0]); });
}

TEST(HoldSizes, beyondPeriodicSides) {
    TestCase c = tankWith("refinements { a { type box; min (0 0); max (0.1 1); meshSize 0.04; } }");
    c.problem.period.length[0] = 1;
    expectSizes(c, [](const Vec<2>& x) { return beyond(std::min(x[0] - 0.1, 1 - x[0])); });
}

TEST(HoldSizes, offWithoutTheWord) {
    EXPECT_FALSE(makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 1) +
                              " } ); refinements { a { type box; min (0 0); max (0.1 1); meshSize 0.04; } }",
                          water, "")
                     .state.sizes.hold());
}

template <int Dim>
void expectTreeFindsTheLeast() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(0, 1);
    const auto point = [&] {
        Vec<Dim> x;
        for (int k = 0; k < Dim; ++k) x[k] = value(random);
        return x;
    };
    SizeTree<Dim> tree;
    Points<Dim> corners;
    std::vector<double> size, reach;
    for (int n = 0; n < 200; ++n) {
        typename SizePlace<Dim>::Corners face;
        face[0] = point();
        for (int k = 1; k < Dim; ++k) face[k] = n % 7 == 0 ? face[0] : Vec<Dim>(face[0] + 0.1 * point());  // or a point
        corners.insert(corners.end(), face.begin(), face.end());
        size.push_back(0.01 + 0.05 * value(random));
        reach.push_back(0.05 * value(random));
        tree.add(face, size.back(), reach.back());
    }
    tree.build();
    for (int n = 0; n < 500; ++n) {
        const Vec<Dim> x = 1.5 * point();
        double least = 0.1;
        for (std::size_t f = 0; f < size.size(); ++f) {
            Face<Dim> face;
            for (int k = 0; k < Dim; ++k) face[k] = static_cast<int>(f) * Dim + k;
            least = std::min(least, size[f] + 0.2 * std::max(0.0, distanceToFace<Dim>(corners, face, x) - reach[f]));
        }
        EXPECT_NEAR(tree.at(x, 0.1), least, 1e-14);
    }
}

TEST(SizeTree, findsTheLeast) {
    expectTreeFindsTheLeast<2>();
    expectTreeFindsTheLeast<3>();
    EXPECT_EQ(SizeTree<2>().at({0, 0}, 0.3), 0.3);
}

}  // namespace
