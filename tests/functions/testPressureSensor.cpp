#include "functions/pressureSensor.hpp"

#include <Eigen/Geometry>

#include "base/error.hpp"
#include "caseFolder.hpp"
#include "functions/sensors.hpp"
#include "io/stateFiles.hpp"

namespace pfem {

using namespace test;

namespace {

void expectRow(const std::vector<double>& row, const std::vector<double>& expected) {
    ASSERT_EQ(row.size(), expected.size());
    for (std::size_t i = 0; i < row.size(); ++i)
        EXPECT_NEAR(row[i], expected[i], 1e-8 * (1 + std::abs(expected[i]))) << i;
}

}  // namespace

TEST(PressureSensor, MeanOfTheHydrostaticPressure) {
    const CaseFolder folder(water, tankConditions);
    const std::string points = "points ((1 0.2 0) (0 0.25 0) (0.31 0 0) (1 0.5 0) (1 0.8 0));";
    auto functions = folder.functions("disc { type pressureSensor; width 0.24; " + points + " }" +
                                      "segment { type pressureSensor; shape segment; width 0.24; " + points + " }");
    functions.start(tank());
    const double R = 0.12;
    // the fourth is half in the water: 2/(pi R^2) int_0^R sqrt(R^2 - s^2) rho g s ds, (1/2R) int_0^R rho g s
    // ds
    expectRow(folder.rows("disc/0/p").at(0), {0, 3000, 2500, 5000, 1e4 * 2 * R / (3 * M_PI), dry});
    expectRow(folder.rows("segment/0/p").at(0), {0, 3000, 2500, 5000, 1e4 * R / 4, dry});
    expectRow(folder.rows("disc/0/wet").at(0), {0, 1, 1, 1, 0.5, 0});
    EXPECT_NE(folder.text("disc/0/p").find("# Sensor 1 (0 0.25 0)\n"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "postProcessing/disc/0/pFiltered"));
}

// Two squares side by side: a sensor on the solid's left face sees the fluid there, wherever the pair goes.
TEST(PressureSensor, RidesOnASolid) {
    const CaseFolder folder(water + rubber, "base { type clamped; }");
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 1) +
                              " } block { type solid; material rubber; " + rectangle(1, 0, 2, 1) +
                              " patches { base { edges ((1 2)); } } } );",
                          water + rubber, "base { type clamped; }");
    for (int i = 0; i < c.state.nodes.size(); ++i) c.state.nodes.p[i] = 7 + 3 * c.state.nodes.X[i][1];
    writeState(folder.path() / "0", c.state);
    auto functions = folder.functions("sensor { type pressureSensor; width 0.3; points ((1 0.45 0) (2 0.45 0)); }");
    functions.start(c.state);
    for (auto& x : c.state.nodes.x) x = Vec<2>(3, 1) + Eigen::Rotation2D<double>(2.0) * x;
    c.state.time = {0.1, 1, 0.1, 0.1};
    functions.execute(c.state);
    for (const auto& row : folder.rows("sensor/0/p")) expectRow(row, {row[0], 7 + 3 * 0.45, dry});
}

TEST(PressureSensor, MistakesAreNamed) {
    const CaseFolder folder(water, tankConditions);
    auto functions = folder.functions("far { type pressureSensor; width 0.01; points ((0.5 0.3 0)); }");
    try {
        functions.start(tank());
        ADD_FAILURE();
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("0.3 m away"), std::string::npos) << error.what();
    }
    EXPECT_THROW(folder.functions("a { type pressureSensor; points ((0 0 0)); }"), UserError);
    EXPECT_THROW(folder.functions("a { type pressureSensor; width 0.1; points (); }"), UserError);
    EXPECT_THROW(folder.functions("a { type pressureSensor; width 0.1; points ((0 0 0)); filter median; }"), UserError);
}

TEST(TimeFilter, LowPassOfAStep) {
    TimeFilter filter("lowPass", 0.02);
    EXPECT_EQ(filter.advance(0, 0), 0);
    double t = 0;
    for (const double dt : {0.001, 0.004, 0.0005, 0.01}) {
        t += dt;
        EXPECT_NEAR(filter.advance(t, 5), 5 * (1 - std::exp(-t / 0.02)), 1e-12);
    }
}

TEST(TimeFilter, MovingAverageOfARamp) {
    TimeFilter filter("movingAverage", 0.02);
    double t = 0;
    for (int k = 0; k < 50; ++k) {
        t += k % 3 == 0 ? 0.0035 : 0.0011;
        const double mean = filter.advance(t, 100 * t);
        if (t > 0.03) {
            EXPECT_NEAR(mean, 100 * (t - 0.01), 1e-10);
        }
    }
}

// Restarted in the middle with what was remembered, also through the time folder: the same bits.
TEST(TimeFilter, GoesOnAfterARestart) {
    const CaseFolder folder(water, tankConditions);
    for (const std::string kind : {"lowPass", "movingAverage"}) {
        const std::string text =
            "s { type pressureSensor; width 0.1; points ((1 0.2 0) (0 0.1 0)); filterTime 0.03; filter " + kind + "; }";
        const auto run = [&](int from, int to, State<2> state) {
            auto functions = folder.functions(text, std::to_string(from));
            functions.start(state);
            for (int k = from + 1; k <= to; ++k) {
                for (auto& p : state.nodes.p) p *= 1 + 0.3 * std::sin(1.7 * k);
                state.time = {0.01 * k, k, 0.01, 0.01};
                functions.execute(state);
                state.memory = functions.memory();
            }
            return state;
        };
        run(0, 9, tank());
        const auto whole = folder.rows("s/0/pFiltered");
        const State<2> half = run(0, 5, tank());
        writeState(folder.path() / "half", half);
        run(5, 9, readState<2>(folder.path() / "half"));
        std::filesystem::remove_all(folder.path() / "half");
        const auto rest = folder.rows("s/5/pFiltered");
        ASSERT_EQ(rest.size(), 4u);
        for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(rest[k], whole[k + 6]) << kind;
    }
}

}  // namespace pfem
