// Curves: lengths, parameters, parts.

#include <numbers>

#include "cases.hpp"
#include "mesher/curve.hpp"
#include "mesher/hilbertOrder.hpp"

namespace pfem::testing {
namespace {

constexpr double pi = std::numbers::pi;

Vec<2> onCircle(double degrees) { return {std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)}; }

TEST(Arc, allDirectionsAndSpans) {
    for (const double span : {-340.0, -200.0, -90.0, -10.0, 10.0, 90.0, 179.0, 180.0, 200.0, 340.0}) {
        for (double start = -180; start < 180; start += 37) {
            const auto arc = Curve::arc(onCircle(start), onCircle(start + 0.3 * span), onCircle(start + span));
            ASSERT_TRUE(arc);
            EXPECT_NEAR(arc->length(), std::abs(span) * pi / 180, 1e-10);
            EXPECT_NEAR((arc->point(0.6) - onCircle(start + 0.6 * span)).norm(), 0, 1e-10);
            const auto s = arc->parameterOf(onCircle(start + 0.25 * span), 1e-9);
            ASSERT_TRUE(s);
            EXPECT_NEAR(*s, 0.25, 1e-9);
            EXPECT_FALSE(arc->parameterOf(onCircle(start - 0.04 * span), 1e-9));
            const auto part = arc->part(0.2, 0.7, arc->point(0.2), arc->point(0.7));
            EXPECT_NEAR((part.point(0.5) - arc->point(0.45)).norm(), 0, 1e-10);
        }
    }
}

TEST(Arc, pointsOfOneLineAreNoArc) { EXPECT_FALSE(Curve::arc({0, 0}, {1, 1}, {3, 3})); }

TEST(Line, parameters) {
    const auto line = Curve::line({1, 1}, {3, 1});
    EXPECT_EQ(line.length(), 2);
    EXPECT_EQ(*line.parameterOf({1.5, 1}, 1e-9), 0.25);
    EXPECT_FALSE(line.parameterOf({1.5, 1.1}, 1e-9));
    EXPECT_FALSE(line.parameterOf({3.5, 1}, 1e-9));
}

TEST(Arc, discArea) {
    const auto mesh =
        meshOf(dictOf(fluidBody("disc", "(-1 0) (1 0)", "edges (arc 0 1 (0 -1) arc 1 0 (0 1));"), "", "0.05"));
    EXPECT_NEAR(mesh.bodies[0].area, pi, 2e-3 * pi);
    for (const auto& x : mesh.state.nodes.x) EXPECT_LT(x.norm(), 1 + 1e-12);
    expectSound(mesh.state);
}

// Both edges of a disc join the same two vertices.
TEST(Arc, patchOfOneOfTwoEdges) {
    const auto patches = [](const std::string& lower, const std::string& both) {
        const std::string disc = fluidBody("disc", "(-1 0) (1 0)",
                                           "edges (arc 0 1 (0 -1) arc 1 0 (0 0.3)); patches { lower { edges (" + lower +
                                               "); } both { edges (" + both + "); } }");
        const auto state = meshOf(dictOf(disc, "", "0.05")).state;
        return std::pair(lengthOf(state, "lower"), lengthOf(state, "both"));
    };
    const double sag = 0.3, radius = (1 + sag * sag) / (2 * sag), upper = 2 * radius * std::asin(1 / radius);
    const auto [lower, both] = patches("(0 1)", "(0 1) (1 0)");
    EXPECT_NEAR(lower, pi, 5e-3);
    EXPECT_NEAR(both, pi + upper, 1e-2);
    EXPECT_NEAR(patches("(1 0)", "(1 0) (1 0)").first, upper, 5e-3);
    EXPECT_NEAR(patches("(1 0)", "(1 0) (1 0)").second, upper, 5e-3);  // named twice
}

TEST(Arc, curvedWallIsShared) {
    const auto state = meshOf(dictOf(fluidBody("water", "(-1 0) (1 0)", "edges (arc 0 1 (0 -1));"),
                                     "bowl { points ((-1 1) (-1 0) (1 0) (1 1)); edges (arc 1 2 (0 -1)); }"))
                           .state;
    expectSound(state);
    EXPECT_NEAR(lengthOf(state, "bowl"), pi + 2, 5e-3);
}

TEST(Hilbert, visitsNeighbours) {
    Points<2> points;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j) points.push_back(Vec<2>(i + 0.5, j + 0.5) / 16);
    points.push_back({0, 0});
    points.push_back({1, 1});
    auto order = hilbertOrder(points);
    std::erase_if(order, [](int i) { return i >= 256; });
    for (std::size_t k = 0; k + 1 < order.size(); ++k)
        EXPECT_NEAR((points[order[k]] - points[order[k + 1]]).norm(), 1.0 / 16, 1e-12);
}

}  // namespace
}  // namespace pfem::testing
