// Bodies that are filled up to a level.

#include "cases.hpp"
#include "mesh/simplex.hpp"
#include "mesher/fillLevel.hpp"
#include "mesher/outline.hpp"

namespace pfem::testing {
namespace {

// a bed with a hump of height 0.3 between x = 0.8 and 1.2, sides up to y = 1
const char* const bed = "(0 0) (0.8 0) (1 0.3) (1.2 0) (2 0) (2 1) (0 1)";

std::vector<Body> pools(const std::string& level, const std::string& vertices = bed) {
    return describe(dictOf(fluidBody("water", vertices, "level " + level + ";"))).bodies;
}

std::string failure(const std::string& level, const std::string& more = "") {
    try {
        describe(dictOf(fluidBody("water", bed, more + "level " + level + ";")));
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

TEST(Level, cutsTheOutline) {
    const auto parts = pools("0.5");
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].name, "water");
    EXPECT_NEAR(outlineArea(parts[0]), 2 * 0.5 - 0.5 * 0.4 * 0.3, 1e-14);
}

TEST(Level, aHumpParts) {
    const double level = 0.12, side = 0.8 + 0.5 * 0.2 * level / 0.3;  // width in the middle of the depth
    const auto parts = pools("0.12");
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[1].name, "water2");
    for (const auto& part : parts) EXPECT_NEAR(outlineArea(part), side * level, 1e-14);
    EXPECT_NE(parts[0].points[0][0] < 1, parts[1].points[0][0] < 1);
}

TEST(Level, throughTheTopOfAHump) {
    const auto parts = pools("0.3");
    double area = 0;
    for (const auto& part : parts) area += outlineArea(part);
    EXPECT_NEAR(area, 2 * 0.3 - 0.5 * 0.4 * 0.3, 1e-14);
}

TEST(Level, clockwiseOutlinesToo) {
    const auto parts = pools("0.5", "(0 1) (2 1) (2 0) (0 0)");
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_NEAR(std::abs(outlineArea(parts[0])), 1, 1e-14);
}

TEST(Level, aboveAllItIsFull) { EXPECT_NEAR(outlineArea(pools("1.5").at(0)), 2 - 0.5 * 0.4 * 0.3, 1e-14); }

TEST(Level, waterMeetsTheWalls) {
    const auto result = meshOf(dictOf(fluidBody("water", bed, "level 0.4;"),
                                      "tank { points ((0 1) (0 0) (0.8 0) (1 0.3) (1.2 0) (2 0) (2 1)); }"));
    EXPECT_TRUE(result.warnings.empty());
    double volume = 0;
    for (const auto& cell : result.state.mesh.fluid.nodes) volume += simplexMeasure<2>(result.state.nodes.x, cell);
    EXPECT_NEAR(volume, 2 * 0.4 - 0.5 * 0.4 * 0.3, 1e-12);
}

TEST(Level, belowTheBottom) {
    EXPECT_NE(failure("-0.1").find("lowest vertex of 'water' is at y = 0, the level at -0.1"), std::string::npos);
    EXPECT_NE(failure("0").find("Nothing is below the level"), std::string::npos);
    EXPECT_NE(failure("0.5", "edges (arc 5 6 (1 1.1)); ").find("straight edges"), std::string::npos);
}

}  // namespace
}  // namespace pfem::testing
