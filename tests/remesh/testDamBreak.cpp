// A small dam break, 0.2 m x 0.1 m, against an elastic wall: the ledger, the walls, and the bits.

#include <gtest/gtest.h>
#include <omp.h>

#include <functional>

#include "mesh/locator.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

TestCase damBreak(const std::string& condition) {
    return makeCase(
        "meshSize 0.01; bodies ("
        " water { type fluid; material water; " +
            rectangle(0, 0, 0.1, 0.2) +
            " }"
            " wall { type solid; material rubber; meshSize 0.005; " +
            rectangle(0.2, 0, 0.21, 0.05) +
            "  patches { base { edges ((0 1)); } } } );"
            " walls ( tank { points ((0 0.5) (0 0) (0.4 0) (0.4 0.5)); } );",
        water + "rubber { type hypoelastic; rho 2500; E 1e6; nu 0; }",
        "tank { type " + condition + "; } base { type clamped; }");
}

void advanceTo(TestCase& c, double time, const std::function<void(const AdvanceReport&)>& check = {}) {
    while (c.state.time.value < time) {
        const double rate = courantRate<2>(c.state).largest;
        const auto report = c.step(std::min(5e-4, 0.2 / (rate + 1e-300)));
        if (check) check(report);
    }
}

class DamBreak : public testing::TestWithParam<const char*> {};

TEST_P(DamBreak, ledgerAddsUp) {
    TestCase c = damBreak(GetParam());
    c.start(5e-4);
    const double first = totalVolume<2>(c.state);
    EXPECT_NEAR(first, 0.02, 1e-6);
    int steps = 0, rejected = 0, iterations = 0;
    double worst = 0, worstLocal = 0, change = 0;
    ASSERT_NO_THROW(advanceTo(c, 0.3, [&](const AdvanceReport& report) {
        ++steps;
        rejected += report.rejected;
        iterations += report.step.iterations;
        worst = std::max(worst, std::abs(totalVolume<2>(c.state) - first - c.ledgerSum()));
        double lost = 0;
        for (double amount : c.state.nodes.lostVolume) lost += amount;
        worstLocal = std::max(
            worstLocal, std::abs(totalVolume<2>(c.state) - first + lost - c.state.ledger[VolumeCause::compression]));
        change = std::max(change, std::abs(totalVolume<2>(c.state) / first - 1));
        for (const auto& s : c.state.mesh.fluid.nodes) ASSERT_GT(simplexMeasure<2>(c.state.nodes.x, s), 0);
    }));
    std::cout << steps << " steps, " << rejected << " rejected, iterations " << static_cast<double>(iterations) / steps
              << ", ledger to " << worst / first << ", largest change " << 100 * change << " %\n";
    for (const auto& [cause, amount] : c.state.ledger.byName())
        std::cout << "  " << cause << " " << 100 * amount / first << " %\n";
    EXPECT_GT(steps, 300);
    EXPECT_LT(worst, 1e-12 * first);
    EXPECT_LT(worstLocal, 1e-12 * first) << "what the nodes lack is not what the fluid has lost";
    // everything is inside
    const Locator<2> solid(c.state.nodes.x, c.state.mesh.solid.nodes);
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const Vec<2>& x = c.state.nodes.x[i];
        EXPECT_TRUE(x[0] > -1e-9 && x[0] < 0.4 + 1e-9 && x[1] > -1e-9) << x.transpose();
        if (topology.ofFluid(i)) {
            EXPECT_FALSE(solid.contains(x)) << x.transpose();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(walls, DamBreak, testing::Values("slip", "noSlip"),
                         [](const auto& test) { return std::string(test.param); });

bool sameBits(const State<2>& a, const State<2>& b) {
    return a.nodes.id == b.nodes.id && a.nodes.x == b.nodes.x && a.nodes.v == b.nodes.v && a.nodes.a == b.nodes.a &&
           a.nodes.p == b.nodes.p && a.nodes.sigma == b.nodes.sigma && a.nodes.dropVolume == b.nodes.dropVolume &&
           a.nodes.lostVolume == b.nodes.lostVolume && a.mesh.fluid.nodes == b.mesh.fluid.nodes &&
           a.ledger.byName() == b.ledger.byName() && a.nextId == b.nextId && a.approach == b.approach;
}

TEST(DamBreakBits, sameInEveryRunAndOnAnyNumberOfThreads) {
    const auto run = [](int threads, double time) {
        const int before = omp_get_max_threads();
        omp_set_num_threads(threads);
        TestCase c = damBreak("slip");
        c.start(5e-4);
        advanceTo(c, time);
        omp_set_num_threads(before);
        return c.state;
    };
    EXPECT_TRUE(sameBits(run(1, 0.2), run(1, 0.2))) << "two runs";
    EXPECT_TRUE(sameBits(run(1, 0.02), run(2, 0.02))) << "one and two threads";
}

}  // namespace
