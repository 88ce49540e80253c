// The ledger as fields: their sums are the ledger, counting changes nothing, a run that goes on has the same.

#include <gtest/gtest.h>

#include "functions/functionObjects.hpp"
#include "io/nodeSets.hpp"
#include "io/sampleState.hpp"
#include "io/stateFiles.hpp"
#include "solver/outputFields.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// 0.2 m2 of water that collapse over a soft step.
TestCase collapse() {
    TestCase c = waterBesideStep();
    c.controls.continuity.volumeCorrectionTime = 0.1;
    c.start(1e-3);
    return c;
}

/// 0.06 m2 of water behind a gate that is lifted after a while: its foot leaves the floor and the water.
TestCase gate() {
    TestCase c = makeCase(
        "meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 0.3, 0.2) +
            " } ); walls ( gate { moving true; points ((0.3 0) (0.3 0.5)); }"
            " tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
        water,
        "tank { type slip; } gate { type slip; motion { velocity expression (\"0\" \"t > 0.02 ? 1 : 0\" \"0\"); } }");
    c.start(1e-3);
    return c;
}

void advanceTo(TestCase& c, double time) {
    while (c.state.time.value < time) c.step(std::min(1e-3, 0.3 / (courantRate<2>(c.state).largest + 1e-300)));
}

/// The sum of a field over the nodes that are written into fluid.vtu.
double writtenSum(const State<2>& state, const std::vector<double>& amounts) {
    const Membership<2> members(state);
    double sum = 0;
    for (std::size_t i = 0; i < amounts.size(); ++i)
        if (members.fluid[i]) sum += amounts[i];
    return sum;
}

/// The largest sum of each field; between two times each must be the ledger's change, and all of them the volume's.
std::map<VolumeCause, double> largestSums(TestCase& c, double interval, int intervals) {
    std::map<VolumeCause, double> largest;
    for (int k = 1; k <= intervals; ++k) {
        c.state.ledger.countFields(c.state.nodes.size());
        const auto before = c.state.ledger;
        const double volume = totalVolume<2>(c.state);
        advanceTo(c, interval * k);
        double all = 0;
        for (const auto& [cause, amounts] : c.state.ledger.fields()) {
            const double sum = writtenSum(c.state, amounts);
            EXPECT_EQ(amounts.size(), c.state.nodes.id.size());
            EXPECT_NEAR(sum, c.state.ledger[cause] - before[cause], 1e-14)
                << textOf(cause).name << " " << c.state.time.value;
            largest[cause] = std::max(largest[cause], std::abs(sum));
            all += sum;
        }
        for (std::size_t which = 0; which < Causes<VolumeCause>::table.size(); ++which) {
            const auto cause = static_cast<VolumeCause>(which);
            EXPECT_GE(c.state.ledger.fields().count(cause), c.state.ledger.has(cause) ? 1u : 0u) << textOf(cause).name;
        }
        EXPECT_NEAR(all, totalVolume<2>(c.state) - volume, 1e-14);
    }
    for (const auto& [cause, amount] : largest) std::cout << "  " << textOf(cause).name << " " << amount << " m2\n";
    return largest;
}

TEST(LedgerFields, sumsAreTheLedger) {
    TestCase c = collapse();
    const auto ids = c.state.nodes.id;
    for (const auto& [cause, amount] : largestSums(c, 0.08, 8))
        if (cause != VolumeCause::returned) {
            EXPECT_GT(amount, 1e-9) << textOf(cause).name;
        }
    EXPECT_NE(c.state.nodes.id, ids) << "no node has come or gone";
}

// A gate that is lifted leaves its water: the node under its foot stays on the floor.
TEST(LedgerFields, aGateThatIsLifted) {
    TestCase c = gate();
    c.state.ledger.countFields(c.state.nodes.size());
    const Id id = c.state.nodes.id[nearestNode(c.state.nodes.x, {0.3, 0})];
    ASSERT_EQ(nSupports(c.state.nodes.wall[nodeOf(c.state.nodes, id)]), 2);
    (void)largestSums(c, 0.05, 3);
    ASSERT_GE(nodeOf(c.state.nodes, id), 0);
    EXPECT_EQ(nSupports(c.state.nodes.wall[nodeOf(c.state.nodes, id)]), 1) << "the gate has not been lifted";
    EXPECT_NEAR(c.state.nodes.x[nodeOf(c.state.nodes, id)][1], 0, 1e-12);
}

TEST(LedgerFields, countingChangesNothing) {
    TestCase c = collapse(), counted = c;
    counted.state.ledger.countFields(counted.state.nodes.size());
    advanceTo(c, 0.3);
    advanceTo(counted, 0.3);
    expectIdentical(c.state, counted.state);
    EXPECT_FALSE(c.state.ledger.counting());
}

// Counting begins at the time folder that the run goes on from.
TEST(LedgerFields, aRestartHasTheSameFields) {
    const TemporaryFolder folder;
    TestCase c = collapse();
    c.state.ledger.countFields(c.state.nodes.size());
    advanceTo(c, 0.2);
    writeState(folder.path() / "0.2", c.state, outputFields(c.problem, c.state));
    c.state.ledger.countFields(c.state.nodes.size());
    TestCase again = c;
    again.state = readState<2>(folder.path() / "0.2");
    EXPECT_FALSE(again.state.ledger.counting());
    again.state.ledger.countFields(again.state.nodes.size());
    advanceTo(c, 0.3);
    advanceTo(again, 0.3);
    EXPECT_EQ(c.state.ledger.fields(), again.state.ledger.fields());
    EXPECT_GT(largest(c.state.ledger.fields().at(VolumeCause::contact)), 0);
}

TEST(LedgerFields, writtenWhenAskedFor) {
    TestCase c = collapse();
    EXPECT_TRUE(outputFields(c.problem, c.state).ofFluid.empty());
    c.state.ledger.countFields(c.state.nodes.size());
    advanceTo(c, 0.01);
    const auto fields = outputFields(c.problem, c.state).ofFluid;
    EXPECT_EQ(fields.size(), 11u);
    ASSERT_EQ(fields.count("ledgerSolver"), 1u);
    EXPECT_EQ(fields.at("ledgerSolver"), c.state.ledger.fields().at(VolumeCause::solver));
    const auto wanted = [](const std::string& entries) {
        const auto dict = Dictionary::parse("functions { mass { type massLedger; " + entries + " } }", "controlDict");
        return FunctionObjects<2>(Case("."), dict, "0").wantAppeared();
    };
    EXPECT_FALSE(wanted(""));
    EXPECT_FALSE(wanted("writeFields no;"));
    EXPECT_TRUE(wanted("writeFields yes;"));
    EXPECT_THROW(wanted("writeFields banana;"), UserError);
}

}  // namespace
