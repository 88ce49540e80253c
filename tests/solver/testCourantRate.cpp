// The rates that limit the time step.

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double h = 0.1;

TestCase waterWith(const Tensor<2>& L, const Vec<2>& v0) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; pattern checkerboard; " +
                              rectangle(0, 0, 1, 1) + " } );",
                          water, "");
    for (int i = 0; i < c.state.nodes.size(); ++i) c.state.nodes.v[i] = v0 + L * c.state.nodes.x[i];
    return c;
}

TEST(CourantRate, ofWaterThatMovesAsOne) {
    const auto rate = courantRate<2>(waterWith(Tensor<2>::Zero(), {3, -4}).state);
    EXPECT_NEAR(rate.largest, 5 / h, 1e-9);
    EXPECT_NEAR(rate.mean, 5 / h, 1e-9);
    EXPECT_NEAR(rate.relative, 0, 1e-9);
    EXPECT_NEAR(rate.compression, 0, 1e-9);
}

TEST(CourantRate, ofCompression) {
    Tensor<2> L;
    L << -3, 0, 0, 1;
    EXPECT_NEAR(courantRate<2>(waterWith(L, {0, 0}).state).compression, 2, 1e-9);
    EXPECT_NEAR(courantRate<2>(waterWith(-L, {0, 0}).state).compression, 0, 1e-9);  // it expands
}

TEST(CourantRate, ofShear) {
    Tensor<2> L;
    L << 0, 2, 0, 0;  // neighbours one row apart differ by 2 h
    const auto rate = courantRate<2>(waterWith(L, {0, 0}).state);
    EXPECT_NEAR(rate.relative, 2, 1e-9);
    EXPECT_NEAR(rate.compression, 0, 1e-9);
}

}  // namespace
