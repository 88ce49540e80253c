// One booking: the sum of its cause, what nodes have got, and the field of the cause follow from it.

#include "state/volumeLedger.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "state/energyCauses.hpp"

using namespace pfem;

namespace {

using Cells = std::array<int, 3>;

template <class Cause>
void expectDistinctNames() {
    std::set<std::string> names;
    for (const auto& text : Causes<Cause>::table) {
        names.insert(text.name);
        EXPECT_GT(std::string(text.meaning).size(), 10u) << text.name;
    }
    EXPECT_EQ(names.size(), Causes<Cause>::table.size());
}

TEST(VolumeLedger, everyCauseHasItsNameInFiles) {
    expectDistinctNames<VolumeCause>();
    expectDistinctNames<EnergyCause>();
    EXPECT_STREQ(textOf(VolumeCause::contact).name, "contact");
    EXPECT_STREQ(textOf(VolumeCause::surface).name, "surface");
    EXPECT_STREQ(textOf(EnergyCause::volume).name, "volume");
}

TEST(VolumeLedger, sumsOverNodesAreSumsOverCauses) {
    VolumeLedger ledger;
    ledger.countFields(4);
    VolumeLedger sheet = ledger.sheet(4);
    sheet.book(VolumeCause::contact, Cells{0, 1, 2}, 0.3);
    sheet.book(VolumeCause::stretched, Cells{1, 2, 3}, -0.6);
    sheet.book(VolumeCause::isolated, 3, 0.25);
    sheet.book(VolumeCause::compression, std::vector<double>{-1, 0, 0, 0});  // nothing makes up for it
    const std::vector<double> atNodes{0.1, 0.1 - 0.2, 0.1 - 0.2, 0.25 - 0.2};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(sheet.atNodes()[i], atNodes[i], 1e-15) << i;
    EXPECT_NEAR(std::accumulate(atNodes.begin(), atNodes.end(), 0.0), sheet.sum(CauseKind::gainOrLoss), 1e-15);
    EXPECT_NEAR(sheet.sum(), 0.3 - 0.6 + 0.25 - 1, 1e-15);

    ledger.book(VolumeCause::contact, 2.0);
    ledger.post(sheet);
    EXPECT_NEAR(ledger[VolumeCause::contact], 2.3, 1e-15);
    for (const auto& [cause, amounts] : ledger.fields())
        EXPECT_NEAR(std::accumulate(amounts.begin(), amounts.end(), 0.0), sheet[cause], 1e-15) << textOf(cause).name;
}

TEST(VolumeLedger, whatHasGoneGetsItsFieldWhenItOccurs) {
    VolumeLedger ledger;
    ledger.countFields(2);
    EXPECT_EQ(ledger.fields().size(), Causes<VolumeCause>::table.size() - 3);
    for (const auto cause : {VolumeCause::gone, VolumeCause::inflow, VolumeCause::outflow})
        EXPECT_EQ(ledger.fields().count(cause), 0u);
    EXPECT_FALSE(ledger.has(VolumeCause::gone));
    ledger.book(VolumeCause::gone, 1, -0.5);
    EXPECT_EQ(ledger.fields().at(VolumeCause::gone), (std::vector<double>{0, -0.5}));
    ledger.countFields(3);
    EXPECT_EQ(ledger.fields().at(VolumeCause::gone), std::vector<double>(3, 0.0));
}

TEST(VolumeLedger, causesOfOlderVersionsAreKept) {
    const std::map<std::string, double> old{{"contact", 1.5}, {"gone", -0.25}, {"insertion", 0.5}};
    VolumeLedger ledger;
    ledger.takeFrom(old);
    EXPECT_EQ(ledger.byName(), old);
    EXPECT_EQ(ledger[VolumeCause::contact], 1.5);
    EXPECT_EQ(ledger.sum(), 1.75);
    EXPECT_EQ(ledger.sum(CauseKind::gainOrLoss), 2.0);
    EXPECT_EQ(ledger.sum(CauseKind::passage), -0.25);
    EXPECT_EQ(ledger.sum(CauseKind::elastic), 0);
    ledger.book(VolumeCause::contact, 0);
    EXPECT_EQ(ledger.byName(), old);
}

}  // namespace
