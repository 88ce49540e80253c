// Nodes that two want: which two, where, and what is done is said; what cannot be is refused with a remedy that works.

#include "solver/sharedPlaces.hpp"

#include <gtest/gtest.h>

#include "solver/checkMotions.hpp"
#include "solver/checkProblem.hpp"
#include "support/solids.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

std::string shared(const TestCase& c, bool contact = false) {
    return sharedPlacesText<2>(c.problem.conditions, contact, c.state);
}

void expectSays(const std::string& text, const std::vector<std::string>& parts) {
    for (const auto& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

TestCase gateUnderAWall(const std::string& foot = "") {
    return makeCase("meshSize 0.02; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.1, 0.14) +
                        " } gate { type solid; material rubber; " + rectangle(0.1, 0, 0.14, 0.08) +
                        " patches { top { edges ((2 3)); } " + foot +
                        " } } ); walls ( tank { points ((0 0.3) (0 0) (1.2 0) (1.2 0.3)); } upper { points ((0.1 "
                        "0.08) (0.1 0.3)); } );",
                    water + rubber,
                    "tank { type slip; } upper { type slip; } top { type clamped; } foot { type symmetry; }");
}

TEST(SharedPlaces, aFreeFootOnTheFloor) {
    const TestCase c = gateUnderAWall("foot { edges ((1 2)); }");
    const std::string text = shared(c);
    expectSays(text,
               {"'tank' (slip) and solid 'rubber' at (0.1 0) and 1 more: nothing holds",
                "'tank' (slip) and 'foot' (symmetry) at (0.14 0): the solid's nodes slide along 'foot'",
                "write a file constant/contact",
                "'upper' (slip) and 'top' (clamped) at (0.1 0.08): 'top' holds the solid's nodes",
                "'top' (clamped) and 'foot' (symmetry) at (0.14 0.08): 'top' holds the nodes and 'foot' does not"});
    expectSays(shared(c, true), {"they meet by contact (constant/contact)"});
    EXPECT_EQ(shared(c, true).find("nothing holds"), std::string::npos);
    const TestCase alone = makeCase("meshSize 0.1; bodies ( s { type solid; material rubber; " +
                                        rectangle(0, 0, 1, 0.5) + " patches { top { edges ((2 3)); } } } );",
                                    rubber, "top { type clamped; }");
    EXPECT_EQ(shared(alone), "");
}

// A duct whose bed is a solid.
TEST(SharedPlaces, openingsAndEdgesOverWhichWaterSlides) {
    const auto text = [](const std::string& bed, const std::string& edges) {
        return shared(makeCase(
            "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.3) +
                " } plate { type solid; material rubber; " + rectangle(0, -0.2, 1, 0) + " patches { bed { edges (" +
                edges +
                "); } } } ); walls ( in { points ((0 0.3) (0 0)); } out { points ((1 0) (1 0.3)); } lid { points ((1 "
                "0.3) (0 0.3)); } );",
            water + rubber,
            "in { type inlet; velocity 1; } out { type outlet; } lid { type slip; } bed { type " + bed + "; }"));
    };
    expectSays(text("clamped", "(3 0) (0 1) (1 2)"),
               {"'in' (inlet) and 'bed' (clamped) at (0 0): the fluid sticks to the solid: nothing passes",
                "'out' (outlet) and 'bed' (clamped) at (1 0)"});
    expectSays(text("clamped", "(0 1)"), {"'in' (inlet) and solid 'rubber' at (0 0)", "clamp the edge there"});
    expectSays(text("slipInterface", "(2 3)"), {"'in' (inlet) and 'bed' (slipInterface) at (0 0): the fluid's nodes "
                                                "slide along the solid, and pass"});
}

/// What is said of a plate with these conditions of its edges `left` and `bottom`, which have a corner; "": nothing.
std::string refusal(const std::string& law, const std::string& left, const std::string& bottom,
                    const std::string& bottomEdge = "(0 1)") {
    const std::string conditions = "left { type clamped; " + left + " } bottom { type clamped; " + bottom + " }";
    const TestCase c = makeCase("meshSize 0.1; bodies ( s { type solid; material m; " + rectangle(0, 0, 1, 0.5) +
                                    " patches { left { edges ((3 0)); } bottom { edges (" + bottomEdge + "); } } } );",
                                "m { " + law + " }", conditions);
    const auto dict = Dictionary::parse(conditions, "boundaryConditions");
    try {
        checkConditions<2>(dict, c.problem.conditions, c.state);
        checkRigidMotions<2>(dict, c.problem, c.state);
    } catch (const UserError& error) {
        return error.what();
    }
    TestCase moved = c;  // what is not refused works
    EXPECT_EQ(moved.step(1e-3).rejected, 0);
    return "";
}

TEST(SharedPlaces, edgesThatDoNotMoveAlike) {
    const std::string elastic = "type hypoelastic; rho 1000; E 1e6; nu 0.3;", rigid = "type rigid; rho 1000;";
    const std::string up = "motion { velocity (0 1 0); }", down = "motion { velocity (0 -1 0); }";
    expectSays(refusal(elastic, up, down), {"'left' and 'bottom' have a common corner at (0 0) but do not move alike",
                                            "the same motion", "end one of them before the corner"});
    expectSays(refusal(elastic, up, ""), {"'left' and 'bottom' have a common corner at (0 0)"});
    EXPECT_EQ(refusal(elastic, up, up), "");
    EXPECT_EQ(refusal(elastic, up, down, "(1 2)"), "");  // on the other side
    expectSays(refusal(rigid, up, down, "(1 2)"), {"'left' at (0", "and 'bottom' at (1", "edges of one rigid body"});
    expectSays(refusal(rigid, up, "", "(1 2)"), {"edges of one rigid body but do not move alike", "stands still"});
    EXPECT_EQ(refusal(rigid, up, up, "(1 2)"), "");
}

// A block that is moved into the floor: neither can give way, and contact cannot help.
TEST(SharedPlaces, whatIsDrivenTogetherIsNamed) {
    TestCase c = makeCase("meshSize 0.1; bodies ( s { type solid; material rubber; " + rectangle(0.3, 0.05, 0.7, 0.35) +
                              " patches { all { edges ((0 1) (1 2) (2 3) (3 0)); } } } ); walls ( floor { points ((0 "
                              "0) (1 0)); } );",
                          rubber, "all { type clamped; motion { velocity (0 -1 0); } } floor { type slip; }");
    c.problem.contact = {true, 0.3};
    try {
        while (c.state.time.value < 0.1) c.step(2e-3);
        ADD_FAILURE() << "it went through the floor";
    } catch (const StepFailure& failure) {
        expectSays(failure.what(), {"is driven into what it meets", "neither can give way"});
    }
    EXPECT_NEAR(c.state.time.value, 0.05, 3e-3);
}

}  // namespace
