// Bad geometry is refused with the place and a hint.

#include "cases.hpp"

namespace pfem::testing {
namespace {

/// Meshing `text` must throw a UserError whose message contains `part`, at `line` of the dictionary.
void expectError(const std::string& text, const std::string& part, int line) {
    try {
        meshOf(text);
        FAIL() << "no error; expected: " << part;
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        EXPECT_NE(error.where().file.find("meshDict"), std::string::npos) << error.what();
        EXPECT_EQ(error.where().line, line) << error.what();
    }
}

const std::string square = "(0 0) (1 0) (1 1) (0 1)";

// In dictOf the first body stands on line 4, the second on line 5; with one body the first wall on line 8.
constexpr int body1 = 4, body2 = 5, wall1 = 8;

TEST(Errors, clockwise) {
    expectError(dictOf(fluidBody("a", "(0 1) (1 1) (1 0) (0 0)")), "((0 0) (1 0) (1 1) (0 1))", body1);
}
TEST(Errors, fewVertices) { expectError(dictOf(fluidBody("a", "(0 0) (1 0)")), "at least 3", body1); }
TEST(Errors, sameVertexTwice) {
    expectError(dictOf(fluidBody("a", "(0 0) (1 0) (1 0) (0 0)")), "2 different points; at least 3", body1);
}
TEST(Errors, selfIntersection) {
    expectError(dictOf(fluidBody("a", "(0 0) (2 0) (2 1) (1 -0.5) (0 1)")), "crosses itself", body1);
}
TEST(Errors, crossingBodies) {
    expectError(dictOf(fluidBody("a", square) + fluidBody("b", "(0.55 0.55) (2 0.55) (2 2) (0.55 2)")), "overlap",
                body2);
}
TEST(Errors, bodyInBody) {
    expectError(dictOf(fluidBody("a", square) + solidBody("b", "(0.3 0.3) (0.7 0.3) (0.7 0.7) (0.3 0.7)")), "holes (b)",
                body2);
}
TEST(Errors, sameBodyTwice) { expectError(dictOf(fluidBody("a", square) + solidBody("b", square)), "overlap", body1); }
TEST(Errors, gap) {
    expectError(dictOf(fluidBody("a", square), "w { points ((0 1) (0 -0.002) (1 -0.002)); }"),
                "neither joined nor apart", wall1);
}
TEST(Errors, roundingIsNoGap) {
    EXPECT_NO_THROW(meshOf(dictOf(fluidBody("a", square), "w { points ((0 1) (0 1e-9) (1 -1e-9)); }")));
}
TEST(Errors, wallThroughBody) {
    expectError(dictOf(fluidBody("a", square), "w { points ((-0.5 0.53) (1.5 0.53)); }"), "cross", wall1);
}
TEST(Errors, wallInsideBody) {
    expectError(dictOf(fluidBody("a", square), "w { points ((0.3 0.5) (0.7 0.5)); }"), "inside body", wall1);
}
TEST(Errors, wallFromFloorIntoBody) {
    expectError(dictOf(fluidBody("a", square), "w { points ((0.3 0) (0.3 0.5)); }"), "inside body", wall1);
}
TEST(Errors, fluidOnTheRight) {
    expectError(dictOf(fluidBody("a", square), "w { points ((1 0) (0 0) (0 1)); }"), "reverse", wall1);
}
TEST(Errors, fluidOnTheRightWithoutContact) {
    expectError(dictOf(fluidBody("a", square), "w { points ((2 -1) (-1 -1) (-1 2)); }"), "reverse", wall1);
    EXPECT_NO_THROW(meshOf(dictOf(fluidBody("a", square), "w { points ((-1 2) (-1 -1) (2 -1)); }")));
    // above the open end of a tank
    EXPECT_NO_THROW(meshOf(dictOf(fluidBody("a", square), "w { points ((-1 -1) (-1 -3) (2 -3) (2 -1)); }")));
}
TEST(Errors, fluidOutsideAClosedBox) {
    expectError(dictOf(fluidBody("a", square), "w { closed yes; points ((2 0) (3 0) (3 1) (2 1)); }"), "right of wall",
                wall1);
}
TEST(Errors, sizeLargerThanBody) { expectError(dictOf(fluidBody("a", square), "", "1.5"), "larger than body", body1); }
TEST(Errors, noSize) {
    expectError("\n\nbodies {\na { type fluid; material water; vertices (" + square + "); } }", "no meshSize", body1);
}
TEST(Errors, sizeNotPositive) {
    expectError(dictOf(fluidBody("a", square), "", "0"), "positive", 1);
    expectError(dictOf(fluidBody("a", square, "meshSize -1;")), "positive", body1);
}
TEST(Errors, tooManyTriangles) { expectError(dictOf(fluidBody("a", square), "", "1e-4"), "Check meshSize", body1); }
TEST(Errors, unknownMaterial) {
    expectError(dictOf("a { type fluid; material watr; vertices (" + square + "); }"), "did you mean 'water'", body1);
}
TEST(Errors, unknownType) {
    expectError(dictOf("a { type gas; material water; vertices (" + square + "); }"), "solid", body1);
}
TEST(Errors, unknownPattern) { expectError(dictOf(fluidBody("a", square, "pattern cross;")), "crossed", body1); }
TEST(Errors, patternNeedsFourSides) {
    expectError(dictOf(fluidBody("a", "(0 0) (1 0) (0 1)", "pattern crossed;")), "four vertices", body1);
}
TEST(Errors, badCells) {
    expectError(dictOf(fluidBody("a", square, "pattern crossed; cells (0 4);")), "positive", body1);
}
TEST(Errors, unknownEdgeType) {
    expectError(dictOf(fluidBody("a", square, "edges (spline 0 1 (0.5 -0.1));")), "arc", body1);
}
TEST(Errors, arcWithoutEdge) {
    expectError(dictOf(fluidBody("a", square, "edges (arc 0 2 (0.5 -0.1));")), "no edge between", body1);
}
TEST(Errors, straightArc) {
    expectError(dictOf(fluidBody("a", square, "edges (arc 0 1 (0.5 0));")), "one line", body1);
}
TEST(Errors, patchWithoutEdge) {
    expectError(dictOf(fluidBody("a", square, "patches { p { edges ((0 2)); } }")), "no edge (0 2)", body1);
}
TEST(Errors, patchNamedAsWall) {
    expectError(dictOf(fluidBody("a", square, "patches { w { edges ((0 1)); } }"), "w { points ((0 1) (0 0)); }"),
                "name of a wall", body1);
}
TEST(Errors, unknownHole) {
    expectError(dictOf(fluidBody("a", square, "holes (cyl);") + solidBody("cyld", "(0.3 0.3) (0.7 0.3) (0.5 0.7)")),
                "did you mean 'cyld'", body1);
}
TEST(Errors, holeTwice) {
    expectError(dictOf(fluidBody("a", square, "holes (b b);") + solidBody("b", "(0.3 0.3) (0.7 0.3) (0.5 0.7)")),
                "'b' twice", body1);
}
TEST(Errors, holeOutside) {
    expectError(dictOf(fluidBody("a", square, "holes (b);") + solidBody("b", "(2 0) (3 0) (3 1)")),
                "does not lie inside", body1);
}
TEST(Errors, threeCoordinates) {
    expectError(dictOf(fluidBody("a", "(0 0 0) (1 0 0) (1 1 3)")), "z is 3 there; write (x y)", body1);
}
TEST(Errors, velocityOutOfThePlane) {
    expectError(dictOf(fluidBody("a", square, "velocity (1 0 2);")), "'velocity' leaves the plane", body1);
    expectError(dictOf(fluidBody("a", square, "velocity expression (\"0\" \"0\" \"x\");")), "z component", body1);
    EXPECT_NO_THROW(meshOf(dictOf(fluidBody("a", square, "velocity expression (\"x\" \"0\" \"0*x\");"))));
}
TEST(Errors, fluidOnBothSidesOfAWall) {
    expectError(
        dictOf(fluidBody("a", square) + fluidBody("b", "(1 0) (2 0) (2 1) (1 1)"), "w { points ((1 0) (1 1)); }"),
        "both sides", 9);
}

}  // namespace
}  // namespace pfem::testing
