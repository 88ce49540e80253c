// Periodic sides: nothing knows where they are.

#include <gtest/gtest.h>

#include "conditions/sides.hpp"
#include "periodicCases.hpp"
#include "state/volume.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// sum rho |e| v of the cells that count.
Vec<2> momentum(const TestCase& c) {
    Vec<2> sum = Vec<2>::Zero();
    for (const auto& cell : c.state.mesh.fluid.nodes)
        for (const int i : cell) sum += simplexMeasure<2>(c.state.nodes.x, cell) / 3 * c.state.nodes.v[i];
    return sum;
}

/// Cells fit together across the sides: every face within the fluid has two.
int openFacesWithin(const TestCase& c, double from, double to) {
    const auto all = unfolded<2>(sidesOf<2>(c.problem, c.state), c.state);
    int count = 0;
    for (const auto& face : makeTopology<2>(all.mesh, c.kinds(), all.nodes.x, all.nodes.wall).faces) {
        const Vec<2> middle = 0.5 * (all.nodes.x[face.nodes[0]] + all.nodes.x[face.nodes[1]]);
        count += middle[1] > from && middle[1] < to && middle[0] > -0.2 && middle[0] < c.problem.period.length[0] + 0.2;
    }
    return count;
}

// ---- plane Poiseuille flow, driven by a body force: height 1, u = g y (1 - y)/(2 nu), Re = 10 with the mean speed 1

TestCase duct(double h) {
    TestCase c = periodic(2.5,
                          "meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " +
                              rectangle(0, 0, 2.5, 1) +
                              " velocity expression (\"6*y*(1-y)\" \"0\"); } ); walls ( bottom { points ((-2 0) (5 "
                              "0)); } top { points ((5 1) (-2 1)); } );",
                          "water { type newtonian; rho 1; mu 0.1; kappa 1e6; }",
                          "bottom { type noSlip; } top { type noSlip; }", {1.2, 0});
    c.start(0.01);
    return c;
}

double profileError(const TestCase& c) {
    double squares = 0;
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const double y = c.state.nodes.x[i][1];
        squares += (c.state.nodes.v[i] - Vec<2>(6 * y * (1 - y), 0)).squaredNorm();
    }
    return std::sqrt(squares / c.state.nodes.size()) / 1.5;
}

TEST(PeriodicSides, poiseuilleFlowOfSecondOrder) {
    double error[2];
    for (const int n : {0, 1}) {
        TestCase c = duct(n == 0 ? 0.2 : 0.1);
        const double volume = totalVolume<2>(c.state);
        run(c, 4, 0.02);
        double sum = 0;
        for (int k = 0; k < 20; ++k) {
            run(c, 0.05, 0.02);
            sum += profileError(c) / 20;
        }
        error[n] = sum;
        EXPECT_NEAR(totalVolume<2>(c.state) / volume, 1, 1e-12);
        EXPECT_EQ(openFacesWithin(c, 0.01, 0.99), 0);
    }
    EXPECT_LT(error[0], 0.06);
    EXPECT_LT(error[1], 0.02);
    EXPECT_GT(error[0] / error[1], 3);
}

// ---- a layer of water with a free surface on a slip floor

TestCase layer(double speed, const std::string& pattern = "") {
    TestCase c =
        periodic(1.5,
                 "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1.5, 0.5) + pattern +
                     " velocity (" + std::to_string(speed) + " 0); } ); walls ( floor { points ((-1 0) (3 0)); } );",
                 water, "floor { type slip; }", {0, -9.81});
    c.tolerance(1e-7);
    c.start(0.01);
    return c;
}

TEST(PeriodicSides, stillWaterRests) {
    TestCase c = layer(0);
    const double volume = totalVolume<2>(c.state);
    EXPECT_NEAR(volume, 0.75, 1e-3);
    run(c, 1, 0.05);
    EXPECT_LT(largest(c.state.nodes.v), 1e-8);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-9);
    EXPECT_EQ(openFacesWithin(c, 0.01, 0.45), 0);
}

TEST(PeriodicSides, uniformStreamGoesOnForEver) {
    TestCase c = layer(2);
    const double volume = totalVolume<2>(c.state);
    run(c, 1.6, 0.02);  // twice through
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-9);
    EXPECT_NEAR(totalVolume<2>(c.state) - c.ledgerSum(), volume, 1e-12);
    const auto points = c.topology().wallPoint;
    for (int i = 0; i < nOwnNodes<2>(c.state); ++i) {
        if (points[i]) continue;
        EXPECT_LT((c.state.nodes.v[i] - Vec<2>(2, 0)).norm(), 1e-9);
        EXPECT_GE(c.state.nodes.x[i][0], 0);
        EXPECT_LT(c.state.nodes.x[i][0], 1.5);
    }
}

// A standing wave, and the same a third of the length farther: the sides are somewhere else in it.
TEST(PeriodicSides, wavesDoNotSeeThem) {
    double height[2], momentumLost[2];
    for (const int n : {0, 1}) {
        TestCase c = layer(0, " pattern crossed; cells (15 5);");
        const double k = 2 * M_PI / 1.5, shift = n == 0 ? 0 : 0.5;
        for (int i = 0; i < c.state.nodes.size(); ++i) {
            const auto& x = c.state.nodes.x[i];
            c.state.nodes.v[i] = 0.1 *
                                 Vec<2>(std::sin(k * (x[0] - shift)) * std::cosh(k * x[1]),
                                        -std::cos(k * (x[0] - shift)) * std::sinh(k * x[1])) /
                                 std::sinh(k * 0.5);
        }
        const double before = momentum(c)[0];
        run(c, 0.2, 0.01);
        height[n] = 0;
        for (const auto& x : c.state.nodes.x) height[n] = std::max(height[n], x[1]);
        momentumLost[n] = momentum(c)[0] - before;
        EXPECT_LT(std::abs(momentumLost[n]), 5e-5);
        EXPECT_EQ(openFacesWithin(c, 0.01, 0.4), 0);
    }
    EXPECT_GT(height[0], 0.51);
    EXPECT_NEAR(height[0], height[1], 3e-5);
}

// A block of water that falls upon the layer in the middle, and at the side, where it is meshed in two halves.
TEST(PeriodicSides, splashesDoNotSeeThem) {
    const auto block = [](const std::string& name, double from, double to, int cells) {
        return name + " { type fluid; material water; " + rectangle(from, 0.375, to, 0.5) +
               " pattern crossed; cells (" + std::to_string(cells) + " 2); velocity (0 -1); } ";
    };
    double height[2];
    for (const int n : {0, 1}) {
        TestCase c = periodic(
            1.5,
            "meshSize 0.0625; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1.5, 0.25) +
                " pattern crossed; cells (24 4); } " +
                (n == 0 ? block("drop", 0.625, 0.875, 4) : block("left", 0, 0.125, 2) + block("right", 1.375, 1.5, 2)) +
                "); walls ( floor { points ((-1 0) (3 0)); } );",
            water, "floor { type slip; }", {0, -9.81});
        c.start(0.001);
        const double volume = totalVolume<2>(c.state);
        EXPECT_NEAR(volume, 1.5 * 0.25 + 0.25 * 0.125, 1e-9);
        run(c, 0.05, 0.002);
        EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-6);
        for (height[n] = 0; c.state.time.value < 0.25;) {
            run(c, 0.05, 0.002);
            double now = 0;
            for (const auto& x : c.state.nodes.x) now = std::max(now, x[1]);
            height[n] += now;
        }
        EXPECT_NEAR(totalVolume<2>(c.state) / volume, 1, 0.01);
        EXPECT_NEAR(totalVolume<2>(c.state) - c.ledgerSum(), volume, 1e-12);
        EXPECT_EQ(openFacesWithin(c, 0.01, 0.1), 0);
    }
    EXPECT_NEAR(height[0], height[1], 0.02 * height[0]);
}

// ---- in both directions at once: Taylor and Green's vortices, |v| ~ exp(-2 nu k^2 t)

TEST(PeriodicSides, vorticesOfTaylorAndGreen) {
    constexpr double k = 2 * M_PI, rate = 2 * 0.01 * k * k;
    TestCase c =
        makeCase("meshSize 0.05; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 1) + " } );",
                 "water { type newtonian; rho 1; mu 0.01; kappa 1e6; }", "", {0, 0});
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        c.state.nodes.v[i] = {std::sin(k * x[0]) * std::cos(k * x[1]), -std::cos(k * x[0]) * std::sin(k * x[1])};
    }
    c.problem.period.length = {1, 1};
    c.start(0.01);
    const auto energy = [&] {
        double sum = 0;
        for (const auto& cell : c.state.mesh.fluid.nodes)
            for (const int i : cell)
                sum += simplexMeasure<2>(c.state.nodes.x, cell) / 6 * c.state.nodes.v[i].squaredNorm();
        return sum;
    };
    const double before = energy(), mean = momentum(c).norm();
    EXPECT_NEAR(before, 0.25, 0.01);
    run(c, 0.5, 0.02);
    EXPECT_NEAR(energy() / before, std::exp(-rate), 0.03 * std::exp(-rate));
    EXPECT_NEAR(totalVolume<2>(c.state), 1, 1e-9);
    EXPECT_NEAR(momentum(c).norm(), mean, 5e-3);  // node control makes some
    EXPECT_EQ(openFacesWithin(c, 0.01, 0.99), 0);
}

// ---- what is refused

TEST(PeriodicSides, refused) {
    const std::string mesh =
        "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1.5, 0.5) + " } ); walls ";
    const TestCase ends = makeCase(mesh + "( floor { points ((-0.2 0) (1.7 0)); } );", water, "floor { type slip; }");
    EXPECT_NE(refusalOf(ends, "x (0 1.5);").find("the wall 'floor' ends at a periodic side"), std::string::npos);
    const TestCase goesOn = makeCase(mesh + "( floor { points ((-1 0) (3 0)); } );", water, "floor { type slip; }");
    EXPECT_EQ(refusalOf(goesOn, "x (0 1.5);"), "");
    EXPECT_NE(refusalOf(goesOn, "x (1.5 0);").find("two planes, the lower one first"), std::string::npos);
    EXPECT_NE(refusalOf(goesOn, "x (0 1.5); z (0 1);").find("no sides in z"), std::string::npos);
    EXPECT_NE(refusalOf(goesOn, "x (0 1.5); y (0 0.5);").find("at least"), std::string::npos);
    const TestCase round = layer(0);
    EXPECT_NE(refusalOf(round, "").find("no file constant/periodic"), std::string::npos);
}

// ---- in space: a stream in a trough

TEST(PeriodicSides, uniformStreamInSpace) {
    const Vec<3> stream(2, 0, 0);
    TestCase3 c = trough(stream);
    c.tolerance(1e-6);
    c.start(0.01);
    const double volume = totalVolume<3>(c.state);
    EXPECT_NEAR(volume, 0.2025, 0.003);
    for (int n = 0; n < 10; ++n) c.step(0.02);
    for (int i = 0; i < c.state.nodes.size(); ++i)
        EXPECT_LT(c.topology().wallPoint[i] ? 0 : (c.state.nodes.v[i] - stream).norm(), 1e-7);
    EXPECT_NEAR(totalVolume<3>(c.state), volume, 1e-9);
}

}  // namespace
