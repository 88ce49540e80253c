#include "base/error.hpp"
#include "functions/discIntegral.hpp"
#include "functions/pressureSensor.hpp"
#include "functions/sensors.hpp"
#include "functions/waveGauge.hpp"
#include "io/stateFiles.hpp"
#include "tank3.hpp"

namespace pfem {

using namespace test;

// Triangles round the disc, in it, and half of it.
TEST(DiscPart, ClosedForms) {
    const double R = 0.3;
    const auto around = discPart({Vec<2>(-5, -5), Vec<2>(5, -5), Vec<2>(0, 7)}, R);
    EXPECT_NEAR(around.area, M_PI * R * R, 1e-14);
    EXPECT_NEAR(around.moment.norm(), 0, 1e-14);
    const auto inside = discPart({Vec<2>(0.1, 0), Vec<2>(0.2, 0.05), Vec<2>(0.1, 0.1)}, R);
    EXPECT_NEAR(inside.area, 0.005, 1e-15);
    EXPECT_NEAR((inside.moment / inside.area - Vec<2>(0.4 / 3, 0.05)).norm(), 0, 1e-14);
    const auto half = discPart({Vec<2>(-9, 0), Vec<2>(9, 0), Vec<2>(0, 9)}, R);
    EXPECT_NEAR(half.area, 0.5 * M_PI * R * R, 1e-14);
    EXPECT_NEAR(half.moment[1], 2 * R * R * R / 3, 1e-14);
    EXPECT_NEAR(discPart({Vec<2>(9, 0), Vec<2>(-9, 0), Vec<2>(0, 9)}, R).area, -0.5 * M_PI * R * R, 1e-14);
    EXPECT_EQ(discPart({Vec<2>(1, 1), Vec<2>(2, 1), Vec<2>(1, 2)}, R).area, 0);
}

// Triangles that fill a square about the disc, wherever their common point is.
TEST(DiscPart, PartsMakeTheWhole) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 1);
    const std::array<Vec<2>, 4> square{Vec<2>(-1, -1), Vec<2>(1, -1), Vec<2>(1, 1), Vec<2>(-1, 1)};
    for (int trial = 0; trial < 200; ++trial) {
        const Vec<2> middle(place(random), place(random));
        AreaMoments sum;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto part = discPart({middle, square[k], square[(k + 1) % 4]}, 0.5);
            EXPECT_GE(part.area, -1e-15);
            sum.area += part.area;
            sum.moment += part.moment;
        }
        EXPECT_NEAR(sum.area, M_PI * 0.25, 1e-13);
        EXPECT_NEAR(sum.moment.norm(), 0, 1e-13);
    }
}

TEST(PressureSensor3, MeanOfTheHydrostaticPressure) {
    const CaseFolder folder(water3, tank3Conditions, tank3Gravity);
    // in the middle of walls, at the water line, on an edge and a corner of the tank (of the floor): a half and a
    // quarter of the disc are on that wall
    auto functions = folder.functions<3>(
        "disc { type pressureSensor; width 0.16; points ((1 0.31 0.2) (0 0.2 0.13) (0.33 0.27 0) (0.4 0.6 0.3)"
        " (1 0.3 0.5) (1 0 0.2) (1 0 0) (1 0.3 0.7)); }");
    functions.start(tank3());
    const double R = 0.08;
    const std::vector<double> p{3000, 3700, 5000, 2000, 1e4 * 2 * R / (3 * M_PI), 0.5 * 3000, 0.25 * 5000, dry},
        wet{1, 1, 1, 1, 0.5, 0.5, 0.25, 0};
    const auto means = folder.rows("disc/0/p").at(0), parts = folder.rows("disc/0/wet").at(0);
    ASSERT_EQ(means.size(), p.size() + 1);
    for (std::size_t k = 0; k < p.size(); ++k) {
        EXPECT_NEAR(means[k + 1], p[k], 1e-8 * (1 + std::abs(p[k]))) << k;
        EXPECT_NEAR(parts[k + 1], wet[k], 1e-9) << k;
    }
}

TEST(PressureSensor3, IsFixedAnywhereOnATriangle) {
    const State<3> state = tank3();
    const std::vector<PatchKind> walls(4, PatchKind::wall);
    for (const Vec<3>& point : Points<3>{{0.9, 0.1, 0}, {0.1, 0.5, 0}, {0, 0.01, 0.79}, {0.5, 0.6, 0.4}, {1, 0.6, 0}}) {
        const auto [anchor, distance] = fixSensor<3>(state, walls, point + Vec<3>::Zero());
        EXPECT_NEAR(distance, 0, 1e-14);
        EXPECT_NEAR((placeOf<3>(anchor, state.nodes).second - point).norm(), 0, 1e-14);
        EXPECT_NEAR(anchor.weights.sum(), 1, 1e-14);
        EXPECT_GE(anchor.weights.minCoeff(), 0);
    }
    EXPECT_NEAR(fixSensor<3>(state, walls, Vec<3>(0.5, 0.3, -0.2)).second, 0.2, 1e-14);
    EXPECT_NEAR(fixSensor<3>(state, walls, Vec<3>(1.3, 0.6, -0.4)).second, 0.5, 1e-14);  // of the floor's corner
}

// Two cubes side by side: a sensor on the solid's face sees the water there, wherever the pair goes.
TEST(PressureSensor3, RidesOnASolid) {
    const CaseFolder folder(water3 + std::string("rubber { type hypoelastic; rho 1000; E 1e6; nu 0.3; }"), "",
                            tank3Gravity);
    State<3> state;
    state.mesh.materials = {"water", "rubber"};
    addLattice(state, state.mesh.fluid, 0, {0, 0, 0}, {1, 1, 1}, 0.25);
    addLattice(state, state.mesh.solid, 1, {1, 0, 0}, {2, 1, 1}, 0.25);
    for (int i = 0; i < state.nodes.size(); ++i)
        state.nodes.p[i] = 7 + 3 * state.nodes.X[i][1] - 2 * state.nodes.X[i][2];
    writeState(folder.path() / "0", state);
    auto functions =
        folder.functions<3>("sensor { type pressureSensor; width 0.3; points ((1 0.45 0.6) (2 0.45 0.6)); }");
    functions.start(state);
    for (auto& x : state.nodes.x) x = Vec<3>(3, 1, 2) + Eigen::AngleAxisd(2.0, Vec<3>(1, 2, 3).normalized()) * x;
    state.time = {0.1, 1, 0.1, 0.1};
    functions.execute(state);
    const auto rows = folder.rows("sensor/0/p");
    ASSERT_EQ(rows.size(), 2u);
    for (const auto& row : rows) {
        EXPECT_NEAR(row.at(1), 7 + 3 * 0.45 - 2 * 0.6, 1e-9);
        EXPECT_EQ(row.at(2), dry);
    }
    EXPECT_THROW(folder.functions<3>("a { type pressureSensor; width 0.1; points ((0 0 0)); shape segment; }"),
                 UserError);
}

TEST(WaveGauge3, SlopingSurface) {
    State<3> state = tank3();
    for (auto& x : state.nodes.x)
        if (x[2] < 0.6) x[2] *= 1 + 0.4 * x[0] + 0.2 * x[1];
    for (const double x : {0.0, 0.123, 0.5, 1.0})
        for (const double y : {0.0, 0.25, 0.3, 0.6}) {
            const auto reading = readGauge<3>(state, {x, y, 0}, {0, 0, 1});
            ASSERT_TRUE(reading) << x << " " << y;
            EXPECT_NEAR(reading->elevation, 0.5 + 0.2 * x + 0.1 * y, 1e-6);
            EXPECT_NEAR(reading->highest, reading->elevation, 1e-12);
            EXPECT_NEAR(reading->depth, reading->elevation, 1e-9);
        }
    EXPECT_NEAR(readGauge<3>(state, {0.5, 0.3, 0.2}, {0, 0, 1})->elevation, 0.43, 1e-6);  // counted from its foot
    EXPECT_FALSE(readGauge<3>(state, {1.001, 0.3, 0}, {0, 0, 1}));
    EXPECT_NEAR(readGauge<3>(state, {-3, 0.31, 0.1}, {1, 0, 0})->elevation, 4, 1e-9);  // a gauge may lie
    const Vec<3> slant = Vec<3>(1, 0.6, 0.4).normalized();
    EXPECT_NEAR(readGauge<3>(state, {0, 0, 0}, slant)->depth, Vec<3>(1, 0.6, 0.4).norm(), 1e-9);
}

TEST(WaveGauge3, FilesTellTheDry) {
    const CaseFolder folder(water3, tank3Conditions, "(0 0 -10)");
    auto functions = folder.functions<3>("gauges { type waveGauge; points ((0.3 0.2 0) (1.5 0 0)); }");
    functions.start(tank3());
    for (const char* file : {"elevation", "highest", "depth"}) {
        const auto row = folder.rows(std::string("gauges/0/") + file).at(0);
        EXPECT_NEAR(row.at(1), 0.5, 1e-9);
        EXPECT_EQ(row.at(2), dry);
    }
    EXPECT_NE(folder.text("gauges/0/depth").find("# Gauge 0 (0.3 0.2 0)\n"), std::string::npos);
    const CaseFolder along(water3, tank3Conditions, "(0 -9.81 0)");  // upwards is y
    auto lying = along.functions<3>("g { type waveGauge; points ((0.3 0 0.2)); }");
    lying.start(tank3());
    EXPECT_NEAR(along.rows("g/0/depth").at(0).at(1), 0.6, 1e-9);
}

}  // namespace pfem
