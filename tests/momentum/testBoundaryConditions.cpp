// What walls and patches let the nodes do.

#include <gtest/gtest.h>

#include <set>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TestCase tank(const std::string& words) {
    return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                        " } ); walls ( floor { points ((0 0) (1 0)); } sides { points ((1 0) (1 1)); } );",
                    water, words);
}

TEST(NodeConstraints, nodesSlideAlongSlipWalls) {
    const TestCase c = tank("floor { type slip; } sides { type slip; }");
    const auto constraints = c.constraints(c.topology());
    const auto at = [&](double x, double y) { return nearestNode(c.state.nodes.x, {x, y}); };
    const int floor = at(0.5, 0), side = at(1, 0.2), corner = at(1, 0), inside = at(0.5, 0.3);
    EXPECT_LT((constraints.project(floor, {3, 4}) - Vec<2>(3, 0)).norm(), 1e-12);
    EXPECT_LT((constraints.project(side, {3, 4}) - Vec<2>(0, 4)).norm(), 1e-12);
    EXPECT_EQ(constraints.project(corner, {3, 4}).norm(), 0);
    EXPECT_EQ(constraints.project(inside, {3, 4}), Vec<2>(3, 4));
}

TEST(NodeConstraints, nodesStickToNoSlipWalls) {
    const TestCase c = tank("floor { type noSlip; } sides { type noSlip; }");
    const auto constraints = c.constraints(c.topology());
    const auto at = [&](double x, double y) { return nearestNode(c.state.nodes.x, {x, y}); };
    EXPECT_EQ(constraints.freedom[at(0.5, 0)].count, 0);
    EXPECT_EQ(constraints.freedom[at(1, 0.2)].count, 0);
    EXPECT_EQ(constraints.freedom[at(1, 0.5)].count, 1);  // the contact line could not move otherwise
}

TEST(NodeConstraints, symmetrySlidesAndCornersHold) {
    const TestCase c = makeCase("meshSize 0.1; bodies ( block { type solid; material rubber; " +
                                    rectangle(0, 0, 1, 0.5) + " patches { sides { edges ((0 1) (1 2)); } } } );",
                                rubber, "sides { type symmetry; }");
    const auto constraints = c.constraints(c.topology());
    const int floor = nearestNode(c.state.nodes.x, {0.5, 0}), side = nearestNode(c.state.nodes.x, {1, 0.2});
    EXPECT_EQ(constraints.freedom[floor].count, 1);
    EXPECT_LT((constraints.project(floor, {3, 4}) - Vec<2>(3, 0)).norm(), 1e-12);
    EXPECT_LT((constraints.project(side, {3, 4}) - Vec<2>(0, 4)).norm(), 1e-12);
    EXPECT_EQ(constraints.freedom[nearestNode(c.state.nodes.x, {1, 0})].count, 0);
    EXPECT_EQ(constraints.freedom[nearestNode(c.state.nodes.x, {1, 0.5})].count, 1);
}

TEST(BoundaryConditions, everyPatchNeedsAKnownCondition) {
    EXPECT_THROW(tank("floor { type slip; }"), UserError);
    EXPECT_THROW(tank("floor { type slip; } sides { type slipp; }"), UserError);
    EXPECT_THROW(tank("floor { type slip; } sides { type slip; } roof { type slip; }"), UserError);
}

TEST(BoundaryConditions, patternsAreForPatchesWithoutAnEntryOfTheirOwn) {
    std::vector<Patch<2>> patches;
    for (const char* name : {"wallLeft", "wallRight", "wallFloor", "base"}) patches.push_back({name, {}});
    const auto read = [&](const std::string& text) {
        const Dictionary dict = Dictionary::parse(text);
        const auto conditions = readBoundaryConditions<2>(dict, patches);
        std::vector<std::string> unused;
        for (const auto& entry : dict.unused()) unused.push_back(entry.key);
        return std::pair(conditions, unused);
    };
    const auto [kinds, unused] = read(
        "wallFloor { type slip; friction 0.1; } \".*\" { type clamped; } \"wall.*\" { type noSlip; } \"wall(Left|Up)\" "
        "{ type slip; }"
        "\"roof.*\" { type slip; } panes { type sideWalls; width 1; friction 0.5; }");
    std::vector<std::string> types;
    for (const auto* type : kinds.type) types.push_back(type->name);
    EXPECT_EQ(types, (std::vector<std::string>{"slip", "noSlip", "slip", "clamped"}));
    EXPECT_EQ(kinds.kind, (std::vector<PatchKind>{PatchKind::wall, PatchKind::wall, PatchKind::wall, PatchKind::edge}));
    EXPECT_EQ(kinds.friction[2], 0.1);
    EXPECT_EQ(kinds.friction[0], 0);
    EXPECT_EQ(kinds.sideFriction, 0.5);
    EXPECT_EQ(unused, std::vector<std::string>{"roof.*"});
    // the last pattern wins; each patch has a motion of its own
    EXPECT_EQ(read("\"wall.*\" { type noSlip; } \".*\" { type clamped; }").first.type[0]->name, "clamped");
    const auto moved =
        read("base { type clamped; } \"wall.*\" { type slip; motion { velocity (1 0 0); } }").first.motion;
    EXPECT_TRUE(moved[0] && moved[1] && moved[2] && !moved[3]);
}

// What a type says must fit together: walls and skins of solids hold the fluid's nodes, but for outlets, through which
// they go; other patches hold their own.
TEST(PatchTypes, tableIsSound) {
    std::set<std::string> names;
    for (const auto& type : patchTypes()) {
        EXPECT_TRUE(names.insert(type.name).second) << type.name;
        EXPECT_GT(type.meaning.size(), 5u) << type.name;
        const bool holds = holdsFluid(type.kind) && type.name != "outlet";
        EXPECT_EQ(holds, type.wet != Constraint::free) << type.name;
        EXPECT_EQ(holds, type.contactLine != Constraint::free) << type.name;
        EXPECT_EQ(type.own == Constraint::free, holdsFluid(type.kind) || type.loads) << type.name;
        EXPECT_EQ(type.entries.empty(), type.read == nullptr) << type.name;
    }
    EXPECT_EQ(typeList([](const auto& type) { return type.mayMove; }, " and "), "slip, noSlip and clamped");
    EXPECT_EQ(typeList([](const auto& type) { return isWall(type.kind); }, " or "), "slip, noSlip, inlet or outlet");
}

TEST(BoundaryConditions, allPatchesWithoutEntryAreNamedAtOnce) {
    try {
        tank("\"roof.*\" { type slip; }");
        ADD_FAILURE();
    } catch (const UserError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("No entry for 'floor', 'sides' of the mesh"), std::string::npos) << text;
    }
}

// What is moved or pulled out of the plane would be so in part only.
TEST(BoundaryConditions, nothingLeavesThePlane) {
    const auto with = [](const std::string& floor) { return tank("floor { " + floor + " } sides { type slip; }"); };
    EXPECT_NO_THROW(with("type slip; motion { velocity (1 2 0); }"));
    EXPECT_NO_THROW(with("type slip; motion { omega 1; origin (0 0 0.5); axis (0 0 -1); }"));
    EXPECT_THROW(with("type slip; motion { velocity (1 2 3); }"), UserError);
    EXPECT_THROW(with("type slip; motion { displacement expression (\"0\" \"0\" \"t\"); }"), UserError);
    EXPECT_THROW(with("type slip; motion { omega 1; origin (0 0 0); axis (1 0 0); }"), UserError);
    const auto pulled = [](const std::string& traction) {
        return makeCase("meshSize 0.1; bodies ( block { type solid; material rubber; " + rectangle(0, 0, 1, 0.5) +
                            " patches { end { edges ((0 1)); } } } );",
                        rubber, "end { type traction; traction " + traction + "; }");
    };
    EXPECT_NO_THROW(pulled("table ((0 (0 0 0)) (1 (5 0 0)))"));
    EXPECT_THROW(pulled("(0 0 5)"), UserError);
    EXPECT_THROW(pulled("table ((0 (0 0 0)) (1 (0 0 5)))"), UserError);
}

}  // namespace
