// Contact rules: what a block that approaches something does.

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A block 0.4 m wide, its lower edge at `gap` above a solid floor, with vertical velocity v.
TestCase blockOver(const std::string& floor, double gap, double v) {
    const std::string block = "block { type fluid; material water; velocity (0 " + std::to_string(v) + "); " +
                              rectangle(0.3, gap, 0.7, gap + 0.3) + " } ";
    if (floor == "solid")
        return makeCase("meshSize 0.05; bodies ( " + block + " floor { type solid; material rubber; " +
                            rectangle(0, -0.1, 1, 0) + " patches { base { edges ((0 1)); } } } );",
                        water + rubber, "base { type clamped; }");
    return makeCase("meshSize 0.05; bodies ( " + block + " ); walls ( floor { points ((0 0) (1 0)); } );", water,
                    "floor { type slip; }");
}

bool touches(const TestCase& c) {
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (topology.wet(i) && (topology.onSolid[i] || topology.onWall[i])) return true;
    return false;
}

TEST(Contact, blockOverASolid) {
    // h = 0.05: contact below 0.5 h and closing
    const auto connects = [](double gap, double v) {
        TestCase c = blockOver("solid", gap, v);
        EXPECT_FALSE(touches(c));
        const double before = totalVolume<2>(c.state);
        remesh<2>(c.controls.remeshing, c.kinds(), c.state);
        EXPECT_NEAR(totalVolume<2>(c.state) - before, c.ledgerSum(), 1e-14);
        if (!touches(c)) {
            EXPECT_NEAR(totalVolume<2>(c.state), before, 1e-14);
        }
        return touches(c);
    };
    EXPECT_FALSE(connects(0.1, -1));  // closing but far
    EXPECT_FALSE(connects(0.03, -1));
    EXPECT_FALSE(connects(0.02, 1));  // near but leaving
    EXPECT_FALSE(connects(0.02, 0));  // near but at rest
    EXPECT_TRUE(connects(0.02, -1));
}

TEST(Contact, blockFallsOnAWall) {
    TestCase c = blockOver("wall", 0.06, -1);
    bool before = touches(c);
    EXPECT_FALSE(before);
    double lowest = 1;
    int steps = 0;
    while (!touches(c) && steps < 60) {
        const auto topology = c.topology();
        lowest = 1;
        for (int i = 0; i < c.state.nodes.size(); ++i)
            if (topology.wet(i)) lowest = std::min(lowest, c.state.nodes.x[i][1]);
        c.step(2e-3);
        ++steps;
    }
    EXPECT_LT(steps, 60);
    EXPECT_LT(lowest, 0.15 * 0.05);  // it touched when it was near, not before
    EXPECT_NEAR(totalVolume<2>(c.state) - 0.12, c.ledgerSum(), 1e-13);
}

TEST(Contact, twoBlocksMeet) {
    const auto connects = [](double gap, double v) {
        TestCase c =
            makeCase("meshSize 0.05; bodies ( left { type fluid; material water; velocity (" + std::to_string(v) +
                         " 0); " + rectangle(0, 0, 0.3, 0.3) + " } right { type fluid; material water; " +
                         rectangle(0.3 + gap, 0, 0.6 + gap, 0.3) + " } );",
                     water, "", {0, 0});
        remesh<2>(c.controls.remeshing, c.kinds(), c.state);
        return c.state.ledger[VolumeCause::contact] > 0;
    };
    EXPECT_FALSE(connects(0.04, 1));
    EXPECT_FALSE(connects(0.01, -1));
    EXPECT_TRUE(connects(0.01, 1));
}

}  // namespace
