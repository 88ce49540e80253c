// Refinements of meshDict: edges have the wanted length in them, grow gently away from them, and counts are as they
// should be.

#include <gtest/gtest.h>

#include "cases.hpp"

using namespace pfem;
using namespace pfem::testing;

namespace {

/// Mean length of the edges whose middle fulfils the condition, over `size`.
template <class Where>
double meanEdge(const State<2>& state, double size, const Where& where) {
    double sum = 0;
    int n = 0;
    for (const auto& [edge, count] : directedEdges(state.mesh.fluid)) {
        const Vec<2>&a = state.nodes.x[edge[0]], &b = state.nodes.x[edge[1]];
        if (!where(Vec<2>(0.5 * (a + b)))) continue;
        sum += (b - a).norm();
        ++n;
    }
    EXPECT_GT(n, 20);
    return sum / n / size;
}

const std::string tank = fluidBody("water", "(0 0) (1 0) (1 1) (0 1)");

TEST(Refinement, Box) {
    const auto mesh = meshOf(dictOf(tank, "", "0.05") +
                             "refinements { corner { type box; min (0.6 -1); max (2 0.3); meshSize 0.01; } }");
    expectSound(mesh.state);
    EXPECT_NEAR(meanEdge(mesh.state, 0.01, [](const Vec<2>& x) { return x.x() > 0.62 && x.y() < 0.28; }), 1, 0.12);
    EXPECT_NEAR(meanEdge(mesh.state, 0.05, [](const Vec<2>& x) { return x.x() < 0.3; }), 1, 0.06);
    for (int i = 0; i < mesh.state.nodes.size(); ++i) {
        const Vec<2>& x = mesh.state.nodes.x[i];
        const double away = std::hypot(std::max(0.0, 0.6 - x.x()), std::max(0.0, x.y() - 0.3));
        EXPECT_NEAR(mesh.state.nodes.h[i], std::min(0.05, 0.01 + 0.2 * away), 1e-12);
    }
    EXPECT_GT(triangleQuality(mesh.state.nodes, mesh.state.mesh.fluid, 0, mesh.state.mesh.fluid.size()).minAngle, 20);
}

TEST(Refinement, Curve) {
    const auto mesh =
        meshOf(dictOf(tank, "", "0.05") +
               "refinements { path { type curve; points ((0 0.5) (0.5 0.5) (1 1)); distance 0.05; meshSize 0.015; } }");
    expectSound(mesh.state);
    EXPECT_NEAR(
        meanEdge(mesh.state, 0.015, [](const Vec<2>& x) { return x.x() < 0.45 && std::abs(x.y() - 0.5) < 0.04; }), 1,
        0.18);
    EXPECT_NEAR(meanEdge(mesh.state, 0.05, [](const Vec<2>& x) { return x.y() < 0.2; }), 1, 0.06);
    EXPECT_GT(triangleQuality(mesh.state.nodes, mesh.state.mesh.fluid, 0, mesh.state.mesh.fluid.size()).minAngle, 20);
}

TEST(Refinement, CoarserThanTheBodyChangesNothing) {
    const auto plain = meshOf(dictOf(tank, "", "0.05"));
    const auto mesh =
        meshOf(dictOf(tank, "", "0.05") + "refinements { all { type box; min (0 0); max (1 1); meshSize 0.1; } }");
    EXPECT_EQ(plain.state.nodes.x, mesh.state.nodes.x);
}

TEST(Refinement, Errors) {
    for (const char* bad :
         {"type bux; min (0 0); max (1 1); meshSize 0.01;", "type box; min (0 0); max (1 0); meshSize 0.01;",
          "type box; min (0 0); max (1 1);", "type box; min (0 0); max (1 1); meshSize 1e-6;",
          "type curve; points ((0 0)); meshSize 0.01;", "type curve; points ((0 0) (0 0)); meshSize 0.01;",
          "type curve; points ((0 0) (1 0)); distance -1; meshSize 0.01;"}) {
        try {
            meshOf(dictOf(tank, "", "0.05") + "refinements { r { " + bad + " } }");
            ADD_FAILURE() << bad;
        } catch (const UserError& error) {
            EXPECT_GT(error.where().line, 0) << bad;
        }
    }
}

}  // namespace
