// Cases whose words are valid but that cannot be meant: refused before the first step.

#include <gtest/gtest.h>

#include "../functions/caseFolder.hpp"
#include "solver/checkMotions.hpp"
#include "solver/checkOpenings.hpp"
#include "solver/checkProblem.hpp"
#include "solver/setup.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

const std::string geometry =
    "meshSize 0.1; bodies ("
    "pool { type fluid; material water; " +
    rectangle(0, 0, 1, 0.5) +
    " }"
    "block { type solid; material rubber; " +
    rectangle(1, 0, 1.4, 0.5) +
    " patches { base { edges ((0 1)); } } } );"
    "walls ( tank { points ((0 1) (0 0) (1.5 0)); }  lid { points ((1.5 2) (0 2)); } );";

/// The line of the entry that is refused; 0 if none is.
int refusedLine(const std::string& tank, const std::string& lid, const std::string& base, int step = 0) {
    const std::string text = "tank { type " + tank + "; traction (1 0 0); }\n" + "lid { type " + lid +
                             "; traction (1 0 0); }\n" + "base { type " + base + "; traction (1 0 0); }\n";
    TestCase c = makeCase(geometry, water + rubber, text);
    c.state.time.index = step;
    try {
        checkConditions<2>(Dictionary::parse(text, "boundaryConditions"), c.problem.conditions, c.state);
    } catch (const UserError& error) {
        return error.where().line;
    }
    return 0;
}

TEST(CheckProblem, conditionsFitTheirPatches) {
    EXPECT_EQ(refusedLine("slip", "noSlip", "clamped"), 0);
    EXPECT_EQ(refusedLine("noSlip", "slip", "symmetry"), 0);
    EXPECT_EQ(refusedLine("slip", "slip", "traction", 7), 0);
}

// Water that comes in must have somewhere to go.
TEST(CheckProblem, inletsHaveAWayOut) {
    const auto refused = [](const std::string& walls, const std::string& conditions) -> std::string {
        const TestCase c = makeCase("meshSize 0.1; bodies ( pool { type fluid; material water; " +
                                        rectangle(0, 0, 1, 0.5) + " } ); walls ( " + walls + " );",
                                    water, conditions);
        try {
            checkOpenings<2>(Dictionary::parse(conditions, "boundaryConditions"), c.problem, c.state);
        } catch (const UserError& error) {
            return std::to_string(error.where().line) + ": " + error.what();
        }
        return "";
    };
    const std::string box =
                          "bed { points ((0 0) (1 0)); } end { points ((1 0) (1 0.5)); } lid { points ((1 0.5) (0 "
                          "0.5)); } left { points ((0 0.5) (0 0)); }",
                      rest = "bed { type slip; } lid { type slip; }\nleft { type inlet; velocity 1; }\n";
    EXPECT_NE(refused(box, rest + "end { type slip; }").find("closed box"), std::string::npos);
    EXPECT_EQ(refused(box, rest + "end { type slip; }").substr(0, 2), "2:");
    EXPECT_EQ(refused(box, rest + "end { type outlet; }"), "");
    const std::string open =
        "tank { points ((0 1) (0 0) (1 0) (1 1)); } nozzle { points ((0.55 0.8) (0.45 0.8)); } "
        "table { points ((0.4 HEIGHT) (0.6 HEIGHT)); }";
    const auto tableAt = [&](const std::string& height) {
        std::string text = open;
        for (auto at = text.find("HEIGHT"); at != std::string::npos; at = text.find("HEIGHT"))
            text.replace(at, 6, height);
        return refused(text, "tank { type slip; } table { type slip; }\nnozzle { type inlet; flowRate 1; }");
    };
    EXPECT_EQ(tableAt("0.58"), "");
    EXPECT_NE(tableAt("0.65").find("comes against the wall 'table', 0.15 m in front"), std::string::npos);
    const std::string weir = "bed { type slip; } lid { type slip; } left { type slip; }\nend { type outlet; level ";
    EXPECT_EQ(refused(box, weir + "0.1; }"), "");
    EXPECT_NE(refused(box, weir + "-0.1; }").find("below the outlet 'end', whose lower end is at 0 m"),
              std::string::npos);
}

// Water at rest that an inlet moves at once takes elastic solids along; not so from rest, in water that flows, and
// rigid bodies.
TEST(CheckProblem, inletsThatStartAtOnce) {
    const auto doubtsAbout = [](const std::string& velocity, const std::string& inlet, const std::string& law) {
        const std::string conditions = "bed { type slip; } held { type clamped; }\nleft { type inlet; velocity " +
                                       inlet + "; } end { type outlet; }";
        const std::string materials = water + "rubber { type " + law + " rho 1500; }";
        const TestCase c = makeCase(
            "meshSize 0.1; bodies ( pool { type fluid; material water; holes (plate); velocity " + velocity + "; " +
                rectangle(0, 0, 2, 0.5) + " } plate { type solid; material rubber; " + rectangle(0.9, 0, 1, 0.3) +
                " patches { held { edges ((0 1)); } } } ); walls ( bed { points ((0 0) (2 0)); } end { points ((2 0) "
                "(2 "
                "0.9)); } left { points ((0 0.9) (0 0)); } );",
            materials, conditions, {0, 0});
        std::string all;
        for (const auto& doubt :
             doubts<2>(Dictionary::parse(materials, "materials"), Dictionary::parse("value (0 0 0);", "g"),
                       Dictionary::parse(conditions, "boundaryConditions"), c.problem, c.state))
            all += doubt;
        return all;
    };
    const std::string elastic = "neoHookean; E 1e5; nu 0.3;", table = "{ type table; values ((0 0) (1 2)); }";
    EXPECT_NE(doubtsAbout("(0 0)", "2", elastic).find("boundaryConditions:2: water at rest"), std::string::npos);
    EXPECT_NE(doubtsAbout("(0 0)", "2; start 0.5", elastic).find("boundaryConditions:2: water at rest"),
              std::string::npos);  // then the water is still at rest
    EXPECT_EQ(doubtsAbout("(0 0)", table, elastic), "");
    EXPECT_NE(doubtsAbout("(0 0)", table + " start 0.5", elastic), "");  // the table has reached 1 m/s by then
    EXPECT_EQ(doubtsAbout("(2 0)", "2", elastic), "");
    EXPECT_EQ(doubtsAbout("(0 0)", "2", "rigid;"), "");
}

// Waves must be longer than eight mesh sizes: of h = 0.1 m those of 0.7 s are 0.76 m long.
TEST(CheckProblem, wavesAreLongBesideTheMesh) {
    const auto doubtsOfPeriod = [](const std::string& period) {
        const std::string conditions =
            "piston { type slip; motion { displacement {\n type waveMaker; depth 0.5; height "
            "0.02; period " +
            period + "; } } }";
        const TestCase c = makeCase("meshSize 0.1; bodies ( pool { type fluid; material water; " +
                                        rectangle(0, 0, 1, 0.5) + " } ); walls ( piston { points ((0 1) (0 0)); } );",
                                    water, conditions);
        return doubts<2>(Dictionary::parse(water, "materials"), Dictionary::parse("value (0 -9.81 0);", "g"),
                         Dictionary::parse(conditions, "boundaryConditions"), c.problem, c.state);
    };
    EXPECT_TRUE(doubtsOfPeriod("0.8").empty());
    ASSERT_EQ(doubtsOfPeriod("0.7").size(), 1U);
    EXPECT_NE(doubtsOfPeriod("0.7")[0].find("boundaryConditions:2: these waves are 0.76"), std::string::npos);
}

// A piston that gives way sees the depth that the water has; two of them are not one.
TEST(CheckProblem, pistonsThatGiveWayKnowTheirDepth) {
    const auto piston = [](const std::string& depth) {
        return "{ type slip; motion {\n absorb { depth " + depth + "; period 2; } } }";
    };
    const auto make = [](const std::string& walls, const std::string& conditions) {
        return makeCase("meshSize 0.1; bodies ( pool { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                            " } ); walls ( " + walls + " );",
                        water, conditions);
    };
    const auto doubtsOfDepth = [&](const std::string& depth) {
        const std::string conditions = "piston " + piston(depth);
        const TestCase c = make("piston { points ((0 1) (0 0)); }", conditions);
        return doubts<2>(Dictionary::parse(water, "materials"), Dictionary::parse("value (0 -9.81 0);", "g"),
                         Dictionary::parse(conditions, "boundaryConditions"), c.problem, c.state);
    };
    EXPECT_TRUE(doubtsOfDepth("0.5").empty());
    ASSERT_EQ(doubtsOfDepth("0.4").size(), 1U);
    EXPECT_NE(doubtsOfDepth("0.4")[0].find("boundaryConditions:2: the water before 'piston' is 0.5 m deep, not 0.4 m"),
              std::string::npos);
    const std::string two = "upper " + piston("0.5") + " lower " + piston("0.5");
    const TestCase c = make("upper { points ((0 1) (0 0.2)); } lower { points ((0 0.2) (0 0)); }", two);
    EXPECT_THROW(checkMotions<2>(Dictionary::parse(two, "boundaryConditions"), c.problem.conditions, c.state),
                 UserError);
}

// A node has one mean: solids of laws in rates and hyperelastic ones may touch with elemental integration only.
TEST(CheckProblem, touchingSolidsOfTwoKindsAreElemental) {
    const auto refused = [](const std::string& right, const std::string& integration, double gap) {
        const TestCase c =
            makeCase("meshSize 0.5; bodies ( left { type solid; material rubber; " + rectangle(0, 0, 1, 1) +
                         " } right { type solid; material other; " + rectangle(1 + gap, 0, 2 + gap, 1) + " } );",
                     rubber + "other { type " + right + "; rho 1500; E 2e5; nu 0.3; }", "");
        try {
            checkLaws<2>(c.problem, c.state.mesh, schemeNamed(integration));
        } catch (const UserError&) {
            return true;
        }
        return false;
    };
    EXPECT_TRUE(refused("neoHookean", "nodal", 0));
    EXPECT_FALSE(refused("neoHookean", "elemental", 0));
    EXPECT_FALSE(refused("neoHookean", "nodal", 0.4));
    EXPECT_FALSE(refused("hypoelastic", "nodal", 0));
}

TEST(CheckProblem, aRigidWallIsSlipOrNoSlip) {
    for (const char* wrong : {"clamped", "symmetry", "traction"}) {
        EXPECT_EQ(refusedLine(wrong, "slip", "clamped"), 1) << wrong;
        EXPECT_EQ(refusedLine(wrong, "slip", "clamped", 7), 1) << wrong;  // the water that slides along it tells
        EXPECT_EQ(refusedLine("slip", wrong, "clamped"), 2) << wrong;
    }
}

TEST(CheckProblem, theEdgeOfASolidIsNoWall) {
    EXPECT_EQ(refusedLine("slip", "slip", "slip"), 3);
    EXPECT_EQ(refusedLine("slip", "slip", "noSlip", 7), 3);
}

TEST(CheckProblem, oneFluid) {
    const std::string oil = "oil { type newtonian; rho 800; mu 0.1; }\n";
    const auto bodies = [](const std::string& second) {
        return "meshSize 0.1; bodies ( a { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
               " } b { type fluid; material " + second + "; " + rectangle(2, 0, 3, 0.5) + " } );";
    };
    const auto materials = Dictionary::parse(water + oil, "materials");
    EXPECT_NO_THROW(checkOneFluid<2>(materials, makeCase(bodies("water"), water + oil, "").state.mesh));
    try {
        checkOneFluid<2>(materials, makeCase(bodies("oil"), water + oil, "").state.mesh);
        FAIL() << "two fluids are accepted";
    } catch (const UserError& error) {
        EXPECT_EQ(error.where().line, 2);
        EXPECT_NE(std::string(error.what()).find("'water' and 'oil'"), std::string::npos);
    }
}

/// What is doubted of water with this density and gravity.
std::string doubtsOf(const std::string& rho, double gravity, const std::string& kappa) {
    const std::string text = "water { type newtonian; rho " + rho + "; mu 0; " + kappa + " }\n";
    TestCase c =
        makeCase("meshSize 0.1; bodies ( pool { type fluid; material water; " + rectangle(0, 0, 1, 0.5) + " } );", text,
                 "", {0, -gravity});
    std::string all;
    for (const auto& doubt : doubts<2>(Dictionary::parse(text, "materials"), Dictionary::parse("value (0 0 0);", "g"),
                                       Dictionary(), c.problem, c.state))
        all += doubt + "\n";
    return all;
}

TEST(CheckProblem, doubtsKnowOtherUnitsThanMetres) {
    EXPECT_EQ(doubtsOf("1000", 9.81, ""), "");
    EXPECT_NE(doubtsOf("1000", 9810, "kappa 1e12;").find("a hundred times that of the earth"), std::string::npos);
    EXPECT_EQ(doubtsOf("1e-9", 9810, "kappa 2100;"), "");  // mm, t, s
    EXPECT_EQ(doubtsOf("1", 981, "kappa 2.1e10;"), "");    // cm, g, s
    for (const char* rho : {"1e-9", "1"})
        EXPECT_NE(doubtsOf(rho, 9.81, "").find("without an entry 'kappa'"), std::string::npos) << rho;
}

// What a box gets faster by is taken off gravity, but not outside.
TEST(CheckProblem, aBoxThatMovesIsRead) {
    const TestCase c =
        makeCase(geometry, water + rubber, "tank { type slip; } lid { type slip; } base { type clamped; }");
    const auto read = [&](const std::string& frame) {
        const CaseFolder folder(water + rubber, "tank { type slip; } lid { type slip; } base { type clamped; }",
                                "(0 -9.81 0); frameVelocity " + frame);
        return readProblem<2>(Case(folder.path()), c.state, nullptr);
    };
    const auto problem = read("table ((0 (0 0 0)) (2 (-1 0 0)) (4 (-1 0 0)))");
    EXPECT_NEAR((problem.gravity - Vec<2>(0.5, -9.81)).norm(), 0, 1e-12);
    EXPECT_NEAR((problemAt<2>(1, problem).frameVelocity - Vec<2>(-0.5, 0)).norm(), 0, 1e-12);
    const auto later = problemAt<2>(3, problem), within = problemWithin<2>(2.5, 1, 3, problem);
    EXPECT_NEAR((later.gravity - Vec<2>(0, -9.81)).norm(), 0, 1e-12);
    EXPECT_NEAR((within.gravity - Vec<2>(0.25, -9.81)).norm(), 0, 1e-12);
    for (const auto& at : {problem, later, within})
        EXPECT_NEAR((at.gravityOutside() - Vec<2>(0, -9.81)).norm(), 0, 1e-12);
    EXPECT_THROW(read("(0 0 1)"), UserError);
}

TEST(CheckProblem, gravityLiesInThePlane) {
    const TestCase c =
        makeCase(geometry, water + rubber, "tank { type slip; } lid { type slip; } base { type clamped; }");
    const auto message = [&](const std::string& g) -> std::string {
        const CaseFolder folder(water + rubber, "tank { type slip; } lid { type slip; } base { type clamped; }", g);
        try {
            readProblem<2>(Case(folder.path()), c.state, nullptr);
        } catch (const UserError& error) {
            EXPECT_EQ(error.where().line, 1);
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("(1 -9.81 0)"), "");
    EXPECT_NE(message("(1 0 -9.81)").find("has the z component -9.81"), std::string::npos);
    EXPECT_NE(message("table ((0 (0 0 0)) (0.01 (0 0 -9.81)))").find("z component"), std::string::npos);
}

}  // namespace
