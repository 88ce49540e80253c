#include "functions/momentumBalance.hpp"

#include "base/error.hpp"
#include "tank3.hpp"

namespace pfem {

using namespace test;

namespace {

Problem<2> problemOfTank(const State<2>& state) {
    TestCase c = makeCase("meshSize 0.5; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( floor { points ((0 0) (1 0)); } right { points ((1 0) (1 1)); } left { "
                              "points ((0 1) (0 0)); } );",
                          water, tankConditions, {0, -10});
    c.problem.time = state.time.value;
    return c.problem;
}

}  // namespace

// A uniform stream u = 2 m/s under hydrostatic pressure, between x = 0.3 and 0.7, with layers of 0.1 m: what comes in
// through one side goes out through the other, rho u^2 D and rho g D^2/2.
TEST(MomentumBalance, OfAUniformStream) {
    State<2> state = tank(0.05);
    for (auto& v : state.nodes.v) v = {2, 0};
    const auto problem = problemOfTank(state);
    const ControlVolume<2> volume{{0.3, 9}, {1, 0}, 0.4, 0.1};
    EXPECT_EQ(volume.weight({0.24, 0}), 0);
    EXPECT_NEAR(volume.weight({0.275, 0}), 0.25, 1e-12);
    EXPECT_EQ(volume.weight({0.5, 0}), 1);
    EXPECT_NEAR(volume.weight({0.725, 0}), 0.25, 1e-12);
    const auto rates = momentumRates<2>(problem, Controls{}, state, volume);
    EXPECT_NEAR(momentumIn<2>(problem, state, volume), 1000 * 2 * 0.4 * 0.5, 4);
    EXPECT_NEAR(rates.flowFrom, 1000 * 4 * 0.5, 0.05 * 2000);
    EXPECT_NEAR(rates.flowTo, -rates.flowFrom, 0.05 * 2000);
    EXPECT_NEAR(rates.pressureFrom, 1000 * 10 * 0.125, 0.05 * 1250);
    EXPECT_NEAR(rates.pressureTo, -rates.pressureFrom, 0.05 * 1250);
    EXPECT_EQ(rates.walls, 0);
    EXPECT_EQ(rates.gravity, 0);
    EXPECT_NEAR(rates.viscous, 0, 1e-9);
    // beyond the right wall, which presses against what comes
    const auto end = momentumRates<2>(problem, Controls{}, state, {{0.5, 0}, {1, 0}, 9, 0.1});
    EXPECT_EQ(end.flowTo, 0);
    EXPECT_NEAR(end.walls, -1000 * 10 * 0.125, 1e-6);
    // down: gravity, and the floor bears what the weight takes
    const auto down = momentumRates<2>(problem, Controls{}, state, {{0.5, 9}, {0, -1}, 18, 0.1});
    EXPECT_NEAR(down.gravity, 1000 * 10 * 0.5, 1e-6);
    EXPECT_NEAR(down.walls, -down.gravity, 1e-6);
}

TEST(MomentumBalance, InSpace) {
    State<3> state = tank3();
    for (auto& v : state.nodes.v) v = {2, 0, 0};
    const CaseFolder folder(water3, tank3Conditions, tank3Gravity);
    auto functions = folder.functions<3>("b { type momentumBalance; from (0.5 0 0); to (2 0 0); width 0.2; }");
    functions.start(state);
    state.time = {0.1, 1, 0.1, 0.1};
    functions.execute(state);
    const auto row = folder.rows("b/0/momentumBalance.dat").at(1);
    EXPECT_NEAR(row[1], 1000 * 2 * 0.6 * 0.25, 15);
    EXPECT_NEAR(row[2], 0.1 * 1000 * 4 * 0.3, 6);           // flow through x = 0.5
    EXPECT_NEAR(row[4], 0.1 * 1000 * 10 * 0.6 * 0.125, 4);  // pressure there
    EXPECT_NEAR(row[6], -0.1 * 1000 * 10 * 0.6 * 0.125, 1e-6);
    EXPECT_NEAR(row[9], -row[2] - row[4] - row[6], 1e-9);  // nothing else has changed
}

// Water that sloshes from wall to wall: what the walls do is what the water's momentum becomes, within 2 % of it.
TEST(MomentumBalance, OfAWaveInATank) {
    TestCase c = tiltedTank("0.05", "type slip;");
    c.start(1e-3);
    const ControlVolume<2> all{{-1, 0}, {1, 0}, 3, 0.1}, half{{0.5, 0}, {1, 0}, 2, 0.2};
    double sums[2] = {0, 0}, through = 0;
    for (int n = 0; n < 60; ++n) {
        const auto before = c.state;
        c.step(5e-3);
        int k = 0;
        for (const auto* volume : {&all, &half}) {
            for (const State<2>* state : {&before, static_cast<const State<2>*>(&c.state)}) {
                const auto rates = momentumRates<2>(c.problem, c.controls, *state, *volume);
                for (const double rate : rates.all()) sums[k] += 0.5 * 5e-3 * rate;
                if (k == 1) through += 0.5 * 5e-3 * rates.pressureFrom;
            }
            ++k;
        }
    }
    EXPECT_GT(momentumIn<2>(c.problem, c.state, all), 50);
    EXPECT_NEAR(sums[0], momentumIn<2>(c.problem, c.state, all), 0.02 * sums[0]);
    EXPECT_NEAR(sums[1], momentumIn<2>(c.problem, c.state, half), 0.01 * through);
}

TEST(MomentumBalance, GoesOnAfterARestart) {
    const CaseFolder folder(water, tankConditions);
    const std::string text = "b { type momentumBalance; from (0.3 0 0); to (2 0 0); }";
    const auto at = [](int k) {
        State<2> now = tank();
        now.time = {0.1 * k, k, 0.1, 0.1};
        for (auto& v : now.nodes.v) v = {1 + now.time.value, 0};
        return now;
    };
    auto whole = folder.functions(text), first = folder.functions(text, "1");
    whole.start(at(0));
    first.start(at(0));
    for (int k = 1; k <= 5; ++k) {
        whole.execute(at(k));
        first.execute(at(k));
    }
    State<2> half = at(5);
    half.memory = first.memory();
    auto rest = folder.functions(text, "0.5");
    rest.start(half);
    rest.execute(at(6));
    whole.execute(at(6));
    const auto rows = folder.rows("b/0/momentumBalance.dat"), again = folder.rows("b/0.5/momentumBalance.dat");
    for (std::size_t k = 1; k < rows.back().size(); ++k) EXPECT_NEAR(again.back()[k], rows.back()[k], 1e-9) << k;
    for (const char* entries : {"from (0 0 0);", "from (1 0 0); to (1 0 0);", "from (0 0 0); to (1 0 1);",
                                "from (0 0 0); to (1 0 0); width -1;"})
        EXPECT_THROW(folder.functions("f { type momentumBalance; " + std::string(entries) + " }"), UserError)
            << entries;
}

}  // namespace pfem
