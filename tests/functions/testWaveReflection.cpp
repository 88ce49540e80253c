#include "base/error.hpp"
#include "caseFolder.hpp"
#include "functions/waveReflection.hpp"
#include "waves/dispersion.hpp"

namespace pfem {

using namespace test;

namespace {

constexpr double window = 2, frequency = 1, incident = 0.01, reflected = 0.002;

/// The tank's surface at time t: a wave to the right and one to the left; exact at the nodes, on which gauges stand.
State<2> waves(const State<2>& still, double t, int step) {
    const double omega = 2 * M_PI * frequency, k = waveNumber(omega, 0.5, 10);
    State<2> state = still;
    state.time = {t, step, 0.01, 0.01};
    for (auto& x : state.nodes.x)
        if (std::abs(x[1] - 0.5) < 1e-9)
            x[1] += incident * std::cos(omega * t - k * x[0] + 0.3) + reflected * std::cos(omega * t + k * x[0] - 1);
    return state;
}

const std::string row =
    "waves { type waveReflection; points ((0.1 0 0) (0.3 0 0) (0.7 0 0)); depth 0.5; window 2; start 0.005; "
    "frequencies (0.6 1.6); }";

}  // namespace

TEST(WaveReflection, tellsWhatGoesFromWhatComesBack) {
    const CaseFolder folder(water, tankConditions);
    const State<2> still = tank();
    auto functions = folder.functions(row);
    functions.start(waves(still, 0, 0));
    for (int n = 1; n <= 450; ++n) functions.execute(waves(still, 0.01 * n, n));  // ends of windows lie within steps
    const auto rows = folder.rows("waves/0/waveReflection.dat");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_NEAR(rows[0][0], 0.005 + window, 1e-9);
    EXPECT_NEAR(rows[1][0], 0.005 + 2 * window, 1e-9);
    for (const auto& one : rows) {
        EXPECT_NEAR(one[1], 4 * incident / std::sqrt(2), 0.005 * incident);
        EXPECT_NEAR(one[2], 4 * reflected / std::sqrt(2), 0.005 * incident);
        EXPECT_NEAR(one[3], reflected / incident, 0.002);
        EXPECT_NEAR(one[4], 1 / frequency, 1e-9);
    }
}

TEST(WaveReflection, goesOnAfterARestart) {
    const CaseFolder folder(water, tankConditions);
    const State<2> still = tank();
    auto whole = folder.functions(row);
    whole.start(waves(still, 0, 0));
    for (int n = 1; n <= 120; ++n) whole.execute(waves(still, 0.01 * n, n));
    State<2> half = waves(still, 1.2, 120);
    half.memory = whole.memory();
    auto rest = folder.functions(row, "1.2");
    rest.start(half);
    for (int n = 121; n <= 210; ++n) {
        whole.execute(waves(still, 0.01 * n, n));
        rest.execute(waves(still, 0.01 * n, n));
    }
    EXPECT_EQ(folder.rows("waves/1.2/waveReflection.dat"), folder.rows("waves/0/waveReflection.dat"));
}

TEST(WaveReflection, badWords) {
    const CaseFolder folder(water, tankConditions);
    for (const char* entries :
         {"points ((0 0 0)); frequencies (0.5 1);", "points ((0 0 0) (0 1 0)); frequencies (0.5 1);",
          "points ((0 0 0) (1 0 0)); frequencies (0.51 0.6);", "points ((0 0 0) (1 0 0)); frequencies (1 0.5);"})
        EXPECT_THROW(folder.functions("w { type waveReflection; depth 0.5; window 2; " + std::string(entries) + " }"),
                     UserError)
            << entries;
}

}  // namespace pfem
