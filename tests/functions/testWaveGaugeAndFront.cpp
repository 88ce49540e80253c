#include "base/error.hpp"
#include "caseFolder.hpp"
#include "functions/front.hpp"
#include "functions/sensors.hpp"
#include "functions/waveGauge.hpp"

namespace pfem {

using namespace test;

TEST(WaveGauge, SlopingSurface) {
    State<2> state = tank();
    for (auto& x : state.nodes.x)
        if (x[1] < 0.6) x[1] *= 1 + 0.4 * x[0];  // surface y = 0.5 + 0.2 x
    for (const double x : {0.0, 0.123, 0.5, 0.9999, 1.0}) {
        const auto reading = readGauge<2>(state, {x, 0}, {0, 1});
        ASSERT_TRUE(reading) << x;
        EXPECT_NEAR(reading->elevation, 0.5 + 0.2 * x, 1e-6);
        EXPECT_NEAR(reading->highest, reading->elevation, 1e-12);
        EXPECT_NEAR(reading->depth, reading->elevation, 1e-12);
    }
    EXPECT_NEAR(readGauge<2>(state, {0.5, 0.2}, {0, 1})->elevation, 0.4, 1e-6);  // counted from its foot
    EXPECT_FALSE(readGauge<2>(state, {1.001, 0}, {0, 1}));
    EXPECT_NEAR(readGauge<2>(state, {0, 0.1}, {1, 0})->elevation, 1, 1e-9);  // a gauge may lie
}

TEST(WaveGauge, WaterUnderASplash) {
    State<2> state;
    state.nodes.resize(6);
    state.nodes.x = {{0, 0}, {2, 0}, {0, 2}, {0, 3}, {2, 3}, {1, 4}};
    state.mesh.fluid = {{{0, 1, 2}, {3, 4, 5}}, {0, 0}};
    const auto reading = readGauge<2>(state, {0.5, -1}, {0, 1});
    ASSERT_TRUE(reading);
    EXPECT_DOUBLE_EQ(reading->elevation, 2.5);
    EXPECT_DOUBLE_EQ(reading->highest, 4.5);
    EXPECT_DOUBLE_EQ(reading->depth, 2);
}

TEST(WaveGauge, FilesTellTheDry) {
    const CaseFolder folder(water, tankConditions);
    auto functions = folder.functions("gauges { type waveGauge; points ((0.3 0 0) (1.5 0 0)); }");
    functions.start(tank());
    for (const char* file : {"elevation", "highest", "depth"}) {
        const auto row = folder.rows(std::string("gauges/0/") + file).at(0);
        EXPECT_NEAR(row.at(1), 0.5, 1e-9);
        EXPECT_EQ(row.at(2), dry);
    }
    EXPECT_THROW(folder.functions("g { type waveGauge; points ((0 0 0)); direction (0 0 0); }"), UserError);
}

TEST(Front, MainBodyAndSplash) {
    State<2> state;
    state.nodes.resize(9);
    // a square in two triangles, a small triangle ahead of it, a drop farther ahead, a corner of a wall
    state.nodes.x = {{0, 0}, {1, 0}, {1, 1}, {0, 1.5}, {2, 0}, {2.5, 0}, {2, 0.5}, {7, 3}, {99, 0}};
    state.nodes.dropVolume[7] = 1e-3;
    state.mesh.fluid = {{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}, {0, 0, 0}};
    const auto right = readFront<2>(state, {1, 0});
    ASSERT_TRUE(right);
    EXPECT_EQ(right->connected, 1);
    EXPECT_EQ(right->any, 7);
    const auto up = readFront<2>(state, {0, 1});
    EXPECT_EQ(up->connected, 1.5);
    EXPECT_EQ(up->node, 3);
    EXPECT_EQ(readFront<2>(state, {-1, 0})->connected, 0);
    EXPECT_FALSE(readFront<2>(State<2>{}, {1, 0}));
}

TEST(Front, File) {
    const CaseFolder folder(water, tankConditions);
    auto functions = folder.functions("front { type front; direction (0 2 0); }");
    functions.start(tank());
    const auto row = folder.rows("front/0/front.dat").at(0);
    EXPECT_NEAR(row.at(1), 0.5, 1e-9);
    EXPECT_NEAR(row.at(4), 0.5, 1e-9);
}

// Directions out of the plane are refused; a place beside the plane, as cases of OpenFOAM have it, is said to be taken
// in it.
TEST(Functions2D, WhatLeavesThePlane) {
    const CaseFolder folder(water, tankConditions);
    EXPECT_THROW(folder.functions("g { type waveGauge; points ((0.3 0 0)); direction (0 1 1); }"), UserError);
    EXPECT_THROW(folder.functions("f { type front; direction (0 1 1); }"), UserError);
    const auto said = [&](const std::string& z) {
        ::testing::internal::CaptureStderr();
        folder.functions("a { type probes; fields (p); probeLocations ((0.3 0.1 " + z +
                         ")); } b { type waveGauge; points ((0.3 0 " + z +
                         ")); } c { type line; fields (p); start (0 0 " + z + "); end (1 0 0); }");
        const std::string text = ::testing::internal::GetCapturedStderr();
        return std::count(text.begin(), text.end(), '\n');
    };
    EXPECT_EQ(said("0"), 0);
    EXPECT_EQ(said("0.05"), 3);
}

}  // namespace pfem
