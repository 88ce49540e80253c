// The one door to new connectivity: its order, and that what a rule does is booked.

#include "solver/remeshingRules.hpp"

#include <gtest/gtest.h>

#include "state/volume.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

using Rule = RemeshingRule<2>;

TestCase column() {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                          water, "tank { type slip; }");
    c.start(1e-3);
    return c;
}

/// A motion that has left the nodes where they are.
Motion<2> rest(const TestCase& c) {
    const std::vector<double> none(c.state.nodes.size(), 0.0);
    return {1e-3, c.topology(), c.state.nodes.x, c.state.nodes.wall, none, none};
}

/// Lifts the middle of the surface by `dy`; returns by how much the fluid grows.
Rule lift(double dy, std::optional<VolumeCause> cause) {
    return {"lift", cause, [dy](const RemeshingContext<2>&, State<2>& state, RemeshingOutcome<2>&) {
                state.nodes.x[nearestNode(state.nodes.x, {0.5, 0.5})][1] += dy;
            }};
}

void run(const std::vector<Rule>& rules, TestCase& c) {
    const Motion<2> motion = rest(c);
    Triangulator<2> triangulator;
    runRules<2>(rules, {c.problem, c.controls.remeshing, motion, triangulator}, c.state);
}

TEST(RemeshingRules, order) {
    std::vector<std::string> names;
    for (const auto& rule : remeshingRules<2>()) names.push_back(rule.name);
    EXPECT_EQ(names, (std::vector<std::string>{"inlets", "outlets", "surfaceShift", "releaseFromWalls", "landOnWalls",
                                               "keepOffBacks", "returnPenetrating", "squeezeOut", "chargeMotion",
                                               "letGo", "holdSizes", "remesh", "keepMomentum", "strike", "dryInlets"}));
}

// All that moves nodes comes before the nodes are charged, and that before the connectivity is made anew.
TEST(RemeshingRules, whatMovesNodesIsChargedBeforeTheyAreReconnected) {
    const auto& rules = remeshingRules<2>();
    const auto placeOf = [&](const std::string& name) {
        return std::find_if(rules.begin(), rules.end(), [&](const Rule& rule) { return rule.name == name; });
    };
    EXPECT_LT(placeOf("chargeMotion"), placeOf("remesh"));
    for (auto rule = placeOf("chargeMotion"); rule != rules.end(); ++rule) EXPECT_FALSE(rule->cause) << rule->name;
}

TEST(RemeshingRules, theRunnerBooksWhatARuleDoes) {
    TestCase c = column();
    const double before = totalVolume<2>(c.state);
    run({lift(0.01, VolumeCause::surface), lift(0.005, {}), lift(0.005, VolumeCause::landed)}, c);
    const double change = totalVolume<2>(c.state) - before;
    EXPECT_NEAR(change, 0.02 * 0.1, 1e-15);  // the node's half of two faces of 0.1 m
    EXPECT_NEAR(c.state.ledger[VolumeCause::surface], 0.5 * change, 1e-15);
    EXPECT_NEAR(c.state.ledger[VolumeCause::landed], 0.5 * change, 1e-15);
    EXPECT_NEAR(c.ledgerSum(), change, 1e-15);
}

TEST(RemeshingRules, energyOfTheRulesIsThatOfRemeshing) {
    TestCase c = column();
    const double before = c.state.energy[EnergyCause::remeshing];
    run({{"push",
          {},
          [](const RemeshingContext<2>&, State<2>& state, RemeshingOutcome<2>&) {
              for (auto& v : state.nodes.v) v = {0, 2};
          }}},
        c);
    EXPECT_NEAR(c.state.energy[EnergyCause::remeshing] - before, 0.5 * 1000 * 0.5 * 4, 1e-9);
}

TEST(RemeshingRules, whatDoesNotApplyIsNotBooked) {
    TestCase c = column();
    Rule never = lift(0.01, VolumeCause::landed);
    never.applies = [](const RemeshingContext<2>&, const State<2>&) { return false; };
    const auto x = c.state.nodes.x;
    run({never}, c);
    EXPECT_EQ(c.state.nodes.x, x);
    EXPECT_FALSE(c.state.ledger.has(VolumeCause::landed));
    c.step(1e-3);
    EXPECT_TRUE(c.state.ledger.has(VolumeCause::landed));
    EXPECT_FALSE(c.state.ledger.has(VolumeCause::returned)) << "there are no solids";
}

TEST(Simulation, stepAdvancesTheTimeByWhatWasAccepted) {
    TestCase c = column();
    const auto report = c.step(2e-3);
    EXPECT_EQ(c.state.time.value, report.dt);
    EXPECT_EQ(c.state.time.deltaT0, report.dt);
    EXPECT_EQ(c.state.time.index, 1);
    c.nextTime = [](const TimeInfo& time, double) { return TimeInfo{0.5, time.index + 1, 0.1, 0.1}; };
    c.step(2e-3);
    EXPECT_EQ(c.state.time.value, 0.5);
    EXPECT_EQ(c.state.time.index, 2);
}

// A copy has no triangulation yet, and goes on to the same bits.
TEST(Simulation, aCopyGoesOnAlike) {
    TestCase c = column();
    c.state.nodes.v[nearestNode(c.state.nodes.x, {0.5, 0.5})] = {0.1, -0.2};
    for (int k = 0; k < 3; ++k) c.step(2e-3);
    TestCase copy = c;
    for (int k = 0; k < 3; ++k) {
        c.step(2e-3);
        copy.step(2e-3);
    }
    EXPECT_EQ(c.state.nodes.x, copy.state.nodes.x);
    EXPECT_EQ(c.state.nodes.p, copy.state.nodes.p);
    EXPECT_EQ(c.state.mesh.fluid.nodes, copy.state.mesh.fluid.nodes);
}

}  // namespace
