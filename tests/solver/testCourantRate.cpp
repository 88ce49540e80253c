// The rates that limit the time step.

#include <gtest/gtest.h>

#include <cmath>

#include "solver/waveRate.hpp"
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

/// The water with a drop of 70 m/s.
State<2> withDrop(const TestCase& c, const Vec<2>& x, const Vec<2>& v, double gravity = 0) {
    State<2> state = c.state;
    state.nodes.append(c.state.nodes, 0);
    state.nodes.id.back() = state.nextId++;
    state.nodes.x.back() = x;
    state.nodes.v.back() = v;
    state.nodes.a.back() = {0, -gravity};
    state.nodes.dropVolume.back() = 1e-4;
    return state;
}

// A drop in free flight counts by what it is going to strike: its way until it is within h of a node, and h there.
TEST(CourantRate, ofDrops) {
    TestCase c = waterWith(Tensor<2>::Zero(), {0, 0});
    const auto drop = [&](const Vec<2>& x, const Vec<2>& v) { return courantRate<2>(withDrop(c, x, v)).largest; };
    EXPECT_NEAR(drop({0.5, 1.01}, {0, -70}), 70 / h, 1e-9);
    EXPECT_NEAR(drop({0.5, 1.3}, {0, -70}), 70 / (h + 0.2), 1e-9);
    EXPECT_EQ(drop({0.5, 1.3}, {0, 70}), 0);  // leaves
    EXPECT_EQ(drop({1.3, -0.4}, {0, -70}), 0);
    EXPECT_EQ(drop({-3, 1.2}, {70, 0}), 0);  // passes over the water
    EXPECT_NEAR(drop({-3, 1.05}, {70, 0}), 70 / (h + 3 - std::sqrt(h * h - 0.05 * 0.05)), 1e-9);
    const int corner = c.state.nodes.size();  // it lands on walls wherever it crosses them
    for (const Vec<2>& x : {Vec<2>(-9, 1.5), Vec<2>(10, 1.5)}) {
        c.state.nodes.append(c.state.nodes, 0);
        c.state.nodes.id.back() = c.state.nextId++;
        c.state.nodes.x.back() = x;
    }
    c.state.mesh.patches.push_back({"roof", {{corner + 1, corner}}});
    EXPECT_EQ(drop({0.5, 1.4}, {0, 70}), 0);
    // a parabola is straight for sqrt(h/g)
    EXPECT_NEAR(courantRate<2>(withDrop(c, {0.5, 1.4}, {0, 70}, 9.81)).largest, 1 / (h / 70 + std::sqrt(h / 9.81)),
                1e-9);
}

// The water moves, too: towards the drop, or with it.
TEST(CourantRate, ofDropsOverMovingWater) {
    EXPECT_NEAR(courantRate<2>(withDrop(waterWith(Tensor<2>::Zero(), {0, 5}), {0.5, 1.3}, {0, -70})).largest,
                75 / (h + 0.2), 1e-9);
    EXPECT_NEAR(courantRate<2>(withDrop(waterWith(Tensor<2>::Zero(), {0, -69}), {0.5, 1.3}, {0, -70})).largest, 69 / h,
                1e-9);
    EXPECT_NEAR(courantRate<2>(withDrop(waterWith(Tensor<2>::Zero(), {0, -60}), {0.5, 1.01}, {0, -70})).mean, 60 / h,
                1e-9);
}

TEST(CourantRate, slowDropsLimitNothing) {
    TestCase c = waterWith(Tensor<2>::Zero(), {3, -4});
    State<2> state = c.state;
    state.nodes.append(c.state.nodes, 0);
    state.nodes.id.back() = state.nextId++;
    state.nodes.x.back() = {0.5, 1.01};
    state.nodes.v.back() = {0, -1};
    state.nodes.dropVolume.back() = 1e-4;
    EXPECT_NEAR(courantRate<2>(state).largest, 5 / h, 1e-9);
}

// Two blocks with air between them: it closes at v/gap, and so does the triangle between their nodes. Wider than what
// may become a contact, or opening, it does not count. Those that have just met (0.02) count as if they were
// contactHeight h high, 0.03, over the longest side of the triangle between them, though the impact has stopped them.
TEST(CourantRate, ofSurfacesThatAreAboutToMeet) {
    const auto rate = [](double gap, double v) {
        const auto block = [&](double y, double speed) {
            return " { type fluid; material water; velocity (0 " + std::to_string(speed) + "); " +
                   rectangle(0, y, 1, y + 0.3) + " } ";
        };
        TestCase c =
            makeCase("meshSize 0.1; bodies ( lower" + block(0, 0.5 * v) + "upper" + block(0.3 + gap, -0.5 * v) + ");",
                     water, "", {0, 0});
        c.step(1e-4);
        EXPECT_NEAR(courantRate<2>(c.state).compression, c.state.approach, 1e-9);
        return c.state.approach;
    };
    EXPECT_NEAR(rate(0.05, 2), 2 / (0.05 - 2e-4), 1e-6);
    EXPECT_NEAR(rate(0.1, 2), 2 / (0.1 - 2e-4), 1e-6);
    EXPECT_NEAR(rate(0.02, 2), 2 / 0.03 * h / std::hypot(h, 0.02 - 2e-4), 1e-6);
    EXPECT_EQ(rate(0.16, 2), 0);
    EXPECT_EQ(rate(0.05, -2), 0);
}

// The limits of what does not move yet.
TEST(WaveRate, isThatOfTheFinestTriangles) {
    TestCase c = waterBesideStep();
    EXPECT_NEAR(gravityWaveRate<2>(c.problem, c.state), std::sqrt(9.81 / 0.05), 1e-12);
    const double modulus = 1e5 * 0.7 / (1.3 * 0.4);
    EXPECT_NEAR(elasticWaveRate<2>(c.problem, c.state), std::sqrt(modulus / 1200) / 0.05, 1e-9);
    c.problem.gravity.setZero();
    EXPECT_EQ(gravityWaveRate<2>(c.problem, c.state), 0);
}

}  // namespace
