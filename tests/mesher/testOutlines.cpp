// Outlines as CAD and drawing programs give them: mended and said, or refused with their points.

#include <fmt/format.h>

#include <numbers>
#include <random>

#include "cases.hpp"
#include "mesher/crossing.hpp"

namespace pfem::testing {
namespace {

/// The body 'a' with a vertex a line, the first one on line 8.
std::string linewise(const std::string& vertices, const std::string& h = "0.1") {
    std::string lines = vertices;
    for (std::size_t at = 0; (at = lines.find(") (", at)) != std::string::npos;) lines.replace(at, 3, ")\n(");
    return "meshSize " + h + ";\nbodies\n{\na\n{\ntype fluid; material water; vertices\n(\n" + lines + "\n);\n}\n}\n";
}

void expectRefused(const std::string& text, const std::string& part, int line) {
    try {
        meshOf(text);
        FAIL() << "no error; expected: " << part;
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("body 'a'"), std::string::npos) << error.what();
        EXPECT_EQ(error.where().line, line) << error.what();
    }
}

bool warnsOf(const MeshResult& mesh, const std::string& part) {
    return std::any_of(mesh.warnings.begin(), mesh.warnings.end(),
                       [&](const auto& w) { return w.find(part) != std::string::npos; });
}

double worstAngle(const MeshResult& mesh) {
    return triangleQuality(mesh.state.nodes, mesh.state.mesh.fluid, 0, mesh.state.mesh.fluid.size()).minAngle;
}

TEST(Outlines, nearDuplicatesAreMergedAndSaid) {
    for (const char* twice : {"(1 0) (1 0)", "(1 0) (1 1e-9)", "(1 0) (1 5e-8)"}) {
        const auto mesh = meshOf(linewise(std::string("(0 0) ") + twice + " (1 1) (0 1)"));
        expectSound(mesh.state);
        EXPECT_NEAR(mesh.bodies[0].area, 1, 1e-6);
        EXPECT_TRUE(warnsOf(mesh, "vertices 1 and 2 (")) << twice;
        EXPECT_TRUE(warnsOf(mesh, "body 'a'")) << twice;
        EXPECT_TRUE(warnsOf(mesh, "meshDict:10)")) << twice;
        EXPECT_GT(worstAngle(mesh), 25);
    }
    EXPECT_TRUE(warnsOf(meshOf(linewise("(0 0) (1 0) (1 1) (0 1) (0 1e-10)")),
                        "vertices 0 and 4 ("));  // the first one once more
    EXPECT_TRUE(meshOf(linewise("(0 0) (1 0) (1 1) (0 1)")).warnings.empty());
}

TEST(Outlines, pointsFinerThanTheMeshAreLeftOutAndSaid) {
    for (const char* d : {"1e-6", "1e-4", "0.004"}) {
        const auto mesh = meshOf(linewise(std::string("(0 0) (1 0) (1 ") + d + ") (1 1) (0 1)"));
        expectSound(mesh.state);
        EXPECT_NEAR(mesh.bodies[0].area, 1, 1e-12);
        EXPECT_TRUE(warnsOf(mesh, "outline of body 'a' has more points than the mesh size can show: 1 of 5")) << d;
        EXPECT_GT(worstAngle(mesh), 25);
    }
    const auto chamfer = meshOf(linewise("(0 0) (0.96 0) (1 0.04) (1 1) (0 1)"));  // a detail that can be seen stays
    EXPECT_TRUE(chamfer.warnings.empty());
    EXPECT_NEAR(chamfer.bodies[0].area, 1 - 0.5 * 0.04 * 0.04, 1e-12);
}

std::string circle(int n, double x, double y, double r) {
    std::string vertices;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        vertices +=
            fmt::format("{}({:.17g} {:.17g})", k == 0 ? "" : " ", x + r * std::cos(angle), y + r * std::sin(angle));
    }
    return vertices;
}

TEST(Outlines, farFromTheOrigin) {
    EXPECT_NEAR(
        meshOf(linewise("(1e9 -1e9) (1000000001 -1e9) (1000000001 -999999999) (1e9 -999999999)")).bodies[0].area, 1,
        1e-6);
}

// The signs of areas between points of one line are round-off.
TEST(Outlines, partsOfOneLineDoNotCross) {
    std::mt19937 random(1);
    std::uniform_real_distribution<> real(-1, 1);
    for (int k = 0; k < 20000; ++k) {
        const Vec<2> a(real(random), real(random)), d(real(random), real(random));
        EXPECT_FALSE(crossingOf(a, a + 0.1 * d, a + 0.2 * d, a + 0.3 * d));
    }
    EXPECT_TRUE(crossingOf({0, 0}, {1, 1}, {1, 0}, {0, 1}));
}

// A spike that the mesh cannot show is left out like any other point.
TEST(Outlines, tinySpikes) {
    const auto mesh = meshOf(linewise("(0 0) (1 0) (1.000002 -0.000002) (0.999999 0.000001) (0 1)"));
    expectSound(mesh.state);
    EXPECT_NEAR(mesh.bodies[0].area, 0.5, 1e-5);
    EXPECT_TRUE(warnsOf(mesh, "of 5 are left out"));
}

TEST(Outlines, aPatchOfMergedPointsIsThereWithoutFaces) {
    const auto state =
        meshOf(dictOf(solidBody("a", "(0 0) (1 0) (1 1e-10) (1 1) (0 1)", "patches { p { edges ((1 2)); } }"))).state;
    EXPECT_TRUE(patchOf(state, "p").faces.empty());
}

// A ring of a hundred thousand points takes a second, not minutes.
TEST(Outlines, aThousandPointsOnACurve) {
    const auto mesh = meshOf(linewise(circle(1000, 0, 0, 1)));
    expectSound(mesh.state);
    EXPECT_NEAR(mesh.bodies[0].area, std::numbers::pi, 0.005 * std::numbers::pi);
    EXPECT_NEAR(mesh.state.mesh.fluid.size(), std::numbers::pi / (0.25 * std::sqrt(3.0) * 0.01), 60);
    EXPECT_GT(worstAngle(mesh), 30);
    EXPECT_NEAR(meshOf(dictOf(fluidBody("a", circle(100000, 0, 0, 1)))).bodies[0].area, std::numbers::pi,
                0.005 * std::numbers::pi);
}

// Water, a solid in it and a wall round it are thinned out alike: they go on sharing their nodes.
TEST(Outlines, sharedLinesStayShared) {
    const auto mesh = meshOf(
        dictOf(fluidBody("water", circle(400, 0, 0, 1), "holes (ball);") + solidBody("ball", circle(300, 0.1, 0, 0.4)),
               "bowl { closed yes; points (" + circle(400, 0, 0, 1) + "); }"));
    expectSound(mesh.state);
    EXPECT_NEAR(lengthOf(mesh.state, "bowl"), 2 * std::numbers::pi, 0.01);
    EXPECT_NEAR(mesh.bodies[0].area + mesh.bodies[1].area, std::numbers::pi, 0.02);
}

TEST(Outlines, aPatchKeepsItsEnds) {
    const auto mesh =
        meshOf(dictOf(solidBody("ball", circle(300, 0, 0, 0.4), "patches { rim { edges ((0 1) (1 2) (2 3)); } }")));
    expectSound(mesh.state);
    EXPECT_NEAR(lengthOf(mesh.state, "rim"), 3 * 2 * std::numbers::pi * 0.4 / 300, 1e-4);
    EXPECT_EQ(patchOf(mesh.state, "rim").faces.size(), 1u);
}

TEST(Outlines, whatTouchesItselfIsNamed) {
    expectRefused(linewise("(0 0) (1 1.5) (2 0) (2 3) (1 1.5) (0 3)"), "vertices 1 and 4 are one point", 12);
    expectRefused(linewise("(0 0) (2 0) (2 3) (1 0) (0 3)"), "vertex 3 (1 0) lies on edge 0-1", 11);
    expectRefused(linewise("(0 0) (2 0) (2 2) (1 2) (1 2.5) (1 2) (0 2)"), "runs back on itself at its vertex 4", 12);
    expectRefused(linewise("(0 0) (2 3) (2 0) (0 3)"), "crosses itself near (1 1.5): edge 0-1 and edge 2-3", 8);
    expectRefused(linewise("(0 0) (2 3) (2 0) (0 2)"), "crosses itself", 8);
    // a hole that is drawn as a part of the outline, with a slit to it
    expectRefused(linewise("(0 0) (2 0) (2 2) (0 2) (0 0) (0.5 0.5) (0.5 1.5) (1.5 1.5) (1.5 0.5) (0.5 0.5)"),
                  "vertices 0 and 4 are one", 12);
}

TEST(Outlines, bowTieOfArcsCrossesItself) {
    expectRefused(
        "meshSize 0.1; bodies { a { type fluid; material water; vertices ((0 0) (1 1) (1 0) (0 1));"
        " edges (arc 0 1 (0.4 0.6)); } }",
        "crosses itself", 1);
}

TEST(Outlines, narrowPlacesAndSpikes) {
    expectRefused(linewise("(0 0) (1 0) (1 1) (0.505 1) (0.5 0.003) (0.495 1) (0 1)"),
                  "of itself at (0.505 1), edge 3-4 and edge 4-5", 11);
    expectRefused(linewise("(0 0) (1 0) (1 1) (0.5005 1) (0.5 1.09) (0.4995 1) (0 1)"), "comes within 0.001 of itself",
                  11);
    expectRefused(dictOf(fluidBody("a", "(0 0) (1 0) (1 1) (0 1)"), "w { points ((0 1) (0 0) (0.09 -0.001)); }"),
                  "wall 'w' (edge 1-2) meet at (0 0) at an angle of 0.64 degrees", 8);
}

TEST(Outlines, holesThatTouchTheOutline) {
    const std::string water = fluidBody("water", "(0 0) (2 0) (2 1) (0 1)", "holes (wall);"),
                      tank = "tank { points ((0 2) (0 0) (2 0) (2 2)); }";
    const auto mesh = meshOf(dictOf(
        water + solidBody("wall", "(0.9 0) (1.1 0) (1.1 0.5) (0.9 0.5)", "patches { base { edges ((0 1)); } }"), tank));
    expectSound(mesh.state);
    EXPECT_NEAR(mesh.bodies[0].area, 2 - 0.1, 1e-12);
    EXPECT_NEAR(lengthOf(mesh.state, "base"), 0.2, 1e-12);
    EXPECT_NEAR(lengthOf(mesh.state, "tank"), 2 + 2 + 2 - 0.2, 1e-12);
    // up to the surface: the water is in two parts
    const auto two = meshOf(dictOf(water + solidBody("wall", "(0.9 0) (1.1 0) (1.1 1) (0.9 1)"), tank));
    expectSound(two.state);
    EXPECT_NEAR(two.bodies[0].area, 2 - 0.2, 1e-12);
    // on its corner only
    const auto corner = meshOf(dictOf(water + solidBody("wall", "(1 0) (1.3 0.5) (0.7 0.5)"), tank));
    expectSound(corner.state);
    EXPECT_NEAR(corner.bodies[0].area, 2 - 0.15, 1e-12);
    // two holes side by side
    const auto pair = meshOf(dictOf(fluidBody("water", "(0 0) (2 0) (2 1) (0 1)", "holes (l r);") +
                                    solidBody("l", "(0.7 0.3) (1 0.3) (1 0.7) (0.7 0.7)") +
                                    solidBody("r", "(1 0.2) (1.3 0.2) (1.3 0.7) (1 0.7)")));
    expectSound(pair.state);
    EXPECT_NEAR(pair.bodies[0].area, 2 - 0.12 - 0.15, 1e-12);
}

// The floor goes on behind the pit whose two sides meet in it.
TEST(Outlines, aWallMayMeetItselfInAPoint) {
    const auto state = meshOf(dictOf(fluidBody("water", "(0 0) (2 0) (2 1) (0 1)"),
                                     "tank { points ((0 2) (0 0) (1 0) (0.8 -0.3) (1.2 -0.3) (1 0) (2 0) (2 2)); }"))
                           .state;
    expectSound(state);
    EXPECT_NEAR(lengthOf(state, "tank"), 6 + 0.4 + 2 * std::hypot(0.2, 0.3), 1e-12);
}

}  // namespace
}  // namespace pfem::testing
