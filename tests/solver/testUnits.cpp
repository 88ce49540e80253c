// A case in other units is the same case. Units that are powers of two of each other leave every digit of a computation
// as it is, so that the results must agree to the last bit: a number that has a unit and is hidden in the code cannot.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// How many of the new units are in a metre, a kilogram and a second.
struct Units {
    double length = 1, mass = 1, time = 1;

    double speed() const { return length / time; }
    double pressure() const { return mass / (length * time * time); }
};

const Units unitsOfTwo{0x1p10, 0x1p-13, 0x1p5};

/// A column beside a soft wall, in a tank; drops above.
TestCase columnAndWall(const Units& u, const std::string& wall) {
    const auto box = [&](double x0, double y0, double x1, double y1) {
        const auto l = [&](double x) { return x * u.length; };
        return fmt::format("vertices (({} {}) ({} {}) ({} {}) ({} {}));", l(x0), l(y0), l(x1), l(y0), l(x1), l(y1),
                           l(x0), l(y1));
    };
    const double density = u.mass / std::pow(u.length, 3);
    TestCase c =
        makeCase(fmt::format("meshSize {}; bodies ( column {{ type fluid; material water; {} }} drop {{ type fluid; "
                             "material water; {} velocity (0 {}); }}"
                             " step {{ type solid; material soft; {} patches {{ base {{ edges ((0 1)); }} }} }} );"
                             " walls ( tank {{ points ((0 {}) (0 0) ({} 0) ({} {})); }} );",
                             0.02 * u.length, box(0, 0, 0.14, 0.28), box(0.2, 0.2, 0.25, 0.25), -3 * u.speed(),
                             box(0.24, 0, 0.27, 0.1), 0.6 * u.length, 0.5 * u.length, 0.5 * u.length, 0.6 * u.length),
                 fmt::format("water {{ type bingham; rho {}; mu {}; tau0 {}; m {}; kappa {}; }} soft {{ type "
                             "hypoelastic; rho {}; E {}; nu 0.3; }}",
                             1000 * density, 1e-3 * u.pressure() * u.time, 0.5 * u.pressure(), 0.1 * u.time,
                             2e6 * u.pressure(), 1200 * density, 2e5 * u.pressure()),
                 "tank { type " + wall + "; } base { type clamped; }", {0, -9.81 * u.speed() / u.time});
    c.controls.continuity.volumeReturnTime *= u.time;
    c.controls.convergence.deltaTMin *= u.time;
    return c;
}

template <class Values>
void expectScaled(const Values& values, const Values& other, double scale, const char* what) {
    ASSERT_EQ(values.size(), other.size()) << what;
    for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(other[i], typename Values::value_type(scale * values[i])) << what << i;
}

void expectSameState(const State<2>& s, const State<2>& other, const Units& u) {
    ASSERT_EQ(s.nodes.id, other.nodes.id);
    ASSERT_EQ(s.nodes.wall, other.nodes.wall);
    ASSERT_EQ(s.mesh.fluid.nodes, other.mesh.fluid.nodes);
    const double area = u.length * u.length;
    expectScaled(s.nodes.x, other.nodes.x, u.length, "x");
    expectScaled(s.nodes.v, other.nodes.v, u.speed(), "v");
    expectScaled(s.nodes.a, other.nodes.a, u.speed() / u.time, "a");
    expectScaled(s.nodes.p, other.nodes.p, u.pressure(), "p");
    expectScaled(s.nodes.sigma, other.nodes.sigma, u.pressure(), "sigma");
    expectScaled(s.nodes.h, other.nodes.h, u.length, "h");
    expectScaled(s.nodes.dropVolume, other.nodes.dropVolume, area, "dropVolume");
    expectScaled(s.nodes.lostVolume, other.nodes.lostVolume, area, "lostVolume");
    EXPECT_EQ(other.approach, s.approach / u.time);
    for (const auto& [cause, amount] : s.ledger.byName())
        EXPECT_EQ(other.ledger.byName().at(cause), area * amount) << cause;
    for (const auto& [cause, amount] : s.energy.byName())
        EXPECT_EQ(other.energy.byName().at(cause), u.pressure() * area * amount) << cause;
}

double nextStep(const TestCase& c, const Units& u) {
    const auto rate = courantRate(c.state);
    return std::min({5e-3 * u.time, 0.5 / rate.largest, 0.4 / rate.relative, 0.2 / rate.compression});
}

class UnitsOfTwo : public testing::TestWithParam<std::string> {};

TEST_P(UnitsOfTwo, leaveNoBitAsItWasNot) {
    const Units metres, &others = unitsOfTwo;
    TestCase c = columnAndWall(metres, GetParam()), o = columnAndWall(others, GetParam());
    const auto set = [&](TestCase& of) {
        Controls& controls = of.controls;
        if (GetParam() == "slip") return;
        controls.integration.integration = "elemental";
        useUpdate(of.problem, "neoHookean");
        controls.continuity.freeSurfacePressure = "strong";
        controls.continuity.stabilisation = "inertia";
        controls.momentum.theta = 0.1;
    };
    set(c);
    set(o);
    c.start(1e-3 * metres.time);
    o.start(1e-3 * others.time);
    expectSameState(c.state, o.state, others);
    for (int step = 0; step < 80 && !HasFatalFailure(); ++step) {
        SCOPED_TRACE(step);
        const double dt = nextStep(c, metres);
        ASSERT_EQ(nextStep(o, others), others.time * dt);
        c.step(dt);
        o.step(others.time * dt);
        expectSameState(c.state, o.state, others);
    }
    EXPECT_NE(c.state.ledger[VolumeCause::contact], 0);  // the drop and the column have struck
}

INSTANTIATE_TEST_SUITE_P(Walls, UnitsOfTwo, testing::Values("slip", "noSlip"));

}  // namespace
