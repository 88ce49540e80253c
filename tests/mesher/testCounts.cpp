// Numbers of triangles against the published meshes, areas, angles, corners.

#include "cases.hpp"

namespace pfem::testing {
namespace {

void expectNear(int count, int published) { EXPECT_NEAR(count, published, 0.05 * published); }

TEST(Counts, damBreakElasticWall) {
    const auto mesh = meshOf(damBreakElasticWall(), 0.002);
    expectNear(mesh.state.mesh.fluid.size(), 24375);
    expectNear(mesh.state.mesh.solid.size(), 540);
}

TEST(Counts, damBreakRigidWall) {
    const auto mesh = meshOf(dictOf(fluidBody("water", "(0 0) (0.6 0) (0.6 0.3) (0 0.3)"),
                                    "tank { points ((0 1) (0 0) (1.61 0) (1.61 1)); }", "0.0042"));
    expectNear(mesh.state.mesh.fluid.size(), 23750);
}

TEST(Counts, wedge) {
    const auto mesh = meshOf(wedge());
    expectNear(mesh.state.mesh.fluid.size(), 112150);
    expectNear(mesh.state.mesh.solid.size(), 6800);
}

TEST(Counts, curvedShellHasTheNumberOfEquilateralTriangles) {
    const auto mesh = meshOf(elasticContainer());
    const double wanted = mesh.bodies[1].area / (0.25 * std::sqrt(3.0) * 0.05 * 0.05);
    EXPECT_NEAR(mesh.state.mesh.solid.size(), wanted, 0.05 * wanted);
}

TEST(Quality, areaIsThePolygons) {
    const auto mesh = meshOf(damBreakElasticWall());
    const auto& state = mesh.state;
    const auto fluid = triangleQuality(state.nodes, state.mesh.fluid, 0, state.mesh.fluid.size());
    const auto solid = triangleQuality(state.nodes, state.mesh.solid, 0, state.mesh.solid.size());
    EXPECT_NEAR(fluid.area, 0.146 * 0.292, 1e-12 * 0.146 * 0.292);
    EXPECT_NEAR(solid.area, 0.012 * 0.08, 1e-12 * 0.012 * 0.08);
}

TEST(Quality, angles) {
    for (const auto& text : {damBreakElasticWall(), elasticContainer(), hydrostaticPlate(), cylinder()}) {
        const auto mesh = meshOf(text);
        const auto& state = mesh.state;
        for (const auto* cells : {&state.mesh.fluid, &state.mesh.solid}) {
            const auto q = triangleQuality(state.nodes, *cells, 0, cells->size());
            EXPECT_GT(q.minAngle, 25);
            EXPECT_GT(q.meanMinAngle, 49);
            EXPECT_NEAR(q.median, 1, 0.1);
        }
        EXPECT_TRUE(wallTriangles(state).empty());
    }
}

TEST(Quality, manySizes) {
    for (double h = 0.0021; h < 0.013; h *= 1.13) {
        const auto mesh = meshOf(damBreakElasticWall(), h);
        const auto& state = mesh.state;
        const auto q = triangleQuality(state.nodes, state.mesh.fluid, 0, state.mesh.fluid.size());
        EXPECT_GT(q.minAngle, 25) << h;
        EXPECT_TRUE(wallTriangles(state).empty()) << h;
        const double wanted = q.area / (0.25 * std::sqrt(3.0) * h * h);
        EXPECT_NEAR(q.count, wanted, 0.05 * wanted) << h;
    }
}

TEST(Quality, cornerNodesHaveTwoTriangles) {
    const auto state = meshOf(damBreakElasticWall()).state;
    std::vector<int> count(state.nodes.size(), 0);
    for (const auto* cells : {&state.mesh.fluid, &state.mesh.solid})
        for (const auto& t : cells->nodes)
            for (const int i : t) ++count[i];
    for (const auto* cells : {&state.mesh.fluid, &state.mesh.solid})
        for (const auto& t : cells->nodes)
            for (const int i : t) EXPECT_GE(count[i], 2);
}

TEST(Quality, acuteCornerBetweenWallsIsBisected) {
    // 50 degrees between two walls
    const auto state =
        meshOf(dictOf(fluidBody("water", "(0 0) (1 0) (0.64 0.7628)"), "v { points ((0.64 0.7628) (0 0) (1 0)); }"))
            .state;
    EXPECT_TRUE(wallTriangles(state).empty());
}

TEST(Quality, sameInputSameMesh) {
    const auto a = meshOf(damBreakElasticWall()).state, b = meshOf(damBreakElasticWall()).state;
    EXPECT_EQ(a.nodes.x, b.nodes.x);
    EXPECT_EQ(a.mesh.fluid.nodes, b.mesh.fluid.nodes);
}

TEST(Quality, neighboursInSpaceAreNeighboursInMemory) {
    const auto state = meshOf(damBreakElasticWall()).state;
    std::vector<int> spread;
    for (const auto& t : state.mesh.fluid.nodes)
        spread.push_back(*std::max_element(t.begin(), t.end()) - *std::min_element(t.begin(), t.end()));
    std::nth_element(spread.begin(), spread.begin() + spread.size() / 2, spread.end());
    EXPECT_LT(spread[spread.size() / 2], 30);
}

}  // namespace
}  // namespace pfem::testing
