// Which nodes go: the limits of distance and height, just below and just above.

#include <gtest/gtest.h>

#include <numeric>

#include "remesh/nodeControl.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double h = 0.1;

NodePlan<2> planOf(const TestCase& c) {
    const auto& nodes = c.state.nodes;
    return planNodes<2>(c.controls.remeshing, movedMesh<2>(c.state, c.topology()), nodes.h,
                        keptNodes<2>(c.state.mesh, nodes.size()));
}

int removed(const TestCase& c) {
    const auto plan = planOf(c);
    return std::accumulate(plan.removed.begin(), plan.removed.end(), 0);
}

TEST(NodePlan, acrossAFilm) {
    const auto film = [](double thickness, double limit) {
        TestCase c = makeCase(
            "meshSize 0.1; bodies ( film { type fluid; material water; " + rectangle(0, 0, 1, h) + " } );", water, "");
        c.controls.remeshing.expert.removeDistanceFilm = limit;
        for (auto& x : c.state.nodes.x) x[1] *= thickness;  // in units of h
        return removed(c);
    };
    EXPECT_GT(film(0.24, 0.25), 0);
    EXPECT_EQ(film(0.26, 0.25), 0);
    EXPECT_GT(film(0.26, 0.27), 0);
    EXPECT_GT(film(0.39, 1), 0);  // never above removeDistanceSurface
    EXPECT_EQ(film(0.41, 1), 0);
}

// A node in the middle of a film would be removed again as it lies under the surface, and keep the sides from being
// divided: so the sides are, though the diagonals are longer.
TEST(NodePlan, sidesOfAFilmAreDividedNotItsDiagonals) {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( film { type fluid; material water; " + rectangle(0, 0, 1, h) + " } );", water, "");
    auto& x = c.state.nodes.x;
    for (auto& point : x) point = {1.75 * point[0], 0.4 * point[1]};
    const auto plan = planOf(c);
    EXPECT_GE(plan.inserted.size(), 5u);
    for (const auto& [i, j] : plan.inserted) EXPECT_NEAR(x[i][1], x[j][1], 1e-12);
}

/// The inner node of the cell at the middle of the upper side, at this height [h] under the middle of its face.
int underSurface(double height, double limit, const std::string& walls = "", const std::string& conditions = "") {
    TestCase c = makeCase(
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) + " } );" + walls,
        water, conditions);
    c.controls.remeshing.removeDistance = 0.5;  // the ends of the face are 0.5 h away at least
    c.controls.remeshing.expert.removeHeight = limit;
    const auto topology = c.topology();
    auto& x = c.state.nodes.x;
    for (const auto& face : topology.faces) {
        const Vec<2> middle = 0.5 * (x[face.nodes[0]] + x[face.nodes[1]]);
        if ((middle - Vec<2>(0.45, 0.5)).norm() > 1e-9) continue;
        for (int i : c.state.mesh.fluid.nodes[face.cell])
            if (i != face.nodes[0] && i != face.nodes[1]) {
                x[i] = middle - Vec<2>(0, height * h);
                return removed(c);
            }
    }
    return -1;
}

TEST(NodePlan, underTheSurface) {
    EXPECT_EQ(underSurface(0.29, 0.3), 1);
    EXPECT_EQ(underSurface(0.31, 0.3), 0);
    EXPECT_EQ(underSurface(0.29, 0), 0);
    // under a wall it may stay: its cell cannot be contact or surface
    EXPECT_EQ(underSurface(0.29, 0.3, "walls ( lid { points ((1 0.5) (0 0.5)); } );", "lid { type slip; }"), 0);
}

}  // namespace
