// Nodes that go take no momentum along (keepMomentum).

#include <gtest/gtest.h>

#include "remesh/remesh.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Water whose inner nodes are too close to each other: many of them go. `velocity`: of a place.
template <class Velocity>
TestCase crowded(Velocity velocity) {
    TestCase c = makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 1) (0 0) (1 0) (1 1)); } );",
                          water, "tank { type slip; }");
    auto& nodes = c.state.nodes;
    for (auto& size : nodes.h) size *= 1.8;
    for (int i = 0; i < nodes.size(); ++i) nodes.v[i] = velocity(nodes.x[i]);
    return c;
}

/// Of the cells, over rho; `more`: velocity to be added, or nothing.
Vec<2> momentumOf(const State<2>& state, const Points<2>& more = {}) {
    Vec<2> sum = Vec<2>::Zero();
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell)
            sum += simplexMeasure<2>(state.nodes.x, cell) / 3 *
                   (state.nodes.v[i] + (more.empty() ? Vec<2>(Vec<2>::Zero()) : more[i]));
    return sum;
}

Vec<2> hump(const Vec<2>& x) { return {std::exp(-200 * std::pow(x[1] - 0.25, 2)), 0.3 * std::sin(9 * x[0])}; }

TEST(KeepMomentum, staysWhereNodesGo) {
    TestCase c = crowded(hump);
    const Vec<2> before = momentumOf(c.state);
    c.controls.remeshing.keepMomentum = true;
    const auto report = remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    EXPECT_GT(report.removed, 20);
    ASSERT_EQ(report.missing.size(), c.state.nodes.x.size());
    const Vec<2> without = momentumOf(c.state), with = momentumOf(c.state, report.missing);
    EXPECT_GT((without - before).norm(), 1e-3 * before.norm());
    EXPECT_LT((with - before).norm(), 1e-13);
    for (const auto& dv : report.missing) EXPECT_LT(dv.norm(), 0.5);
}

TEST(KeepMomentum, nothingIsMissingFromLinearVelocities) {
    TestCase c = crowded([](const Vec<2>& x) { return Vec<2>(1 + 2 * x[0] - x[1], 3 * x[1]); });
    c.controls.remeshing.keepMomentum = true;
    const auto report = remesh<2>(c.controls.remeshing, c.kinds(), c.state);
    EXPECT_GT(report.removed, 20);
    for (const auto& dv : report.missing) EXPECT_LT(dv.norm(), 1e-12);
}

TEST(KeepMomentum, onlyWhereItIsAskedFor) {
    TestCase c = crowded(hump);
    EXPECT_TRUE(remesh<2>(c.controls.remeshing, c.kinds(), c.state).missing.empty());
}

}  // namespace
