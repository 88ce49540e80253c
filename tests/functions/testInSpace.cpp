// Function objects that are the same code in both dimensions are right in space.

#include "base/error.hpp"
#include "functions/forces.hpp"
#include "functions/front.hpp"
#include "functions/sensors.hpp"
#include "tank3.hpp"

namespace pfem {

using namespace test;

namespace {

constexpr double weight = 1000 * 10 * 0.3;  // of the tank's water [N]

const CaseFolder& tankFolder() {
    static const CaseFolder folder(water3, tank3Conditions, tank3Gravity);
    return folder;
}

/// The last row of a table that one function writes for a state.
std::vector<double> row(const std::string& text, const State<3>& state, const std::string& file) {
    auto functions = tankFolder().functions<3>(text);
    functions.start(state);
    return tankFolder().rows(file).back();
}

void expectVector(const std::vector<double>& row, std::size_t first, const Vec<3>& expected, double error) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(row.at(first + c), expected[c], error) << first << " " << c;
}

}  // namespace

// p = rho g (H - z): on the floor the weight in its middle, on a wall of breadth b rho g b H^2/2 at H/3.
TEST(InSpace, HydrostaticForcesAndMoments) {
    const auto force = [](const std::string& patches, const std::string& file) {
        return row("f { type forces; patches (" + patches + "); }", tank3(), "f/0/" + file + ".dat");
    };
    expectVector(force("floor", "force"), 1, {0, 0, -weight}, 1e-8);
    expectVector(force("floor", "force"), 4, {0, 0, -weight}, 1e-8);
    expectVector(force("floor", "force"), 7, {0, 0, 0}, 1e-12);
    expectVector(force("floor", "moment"), 1, Vec<3>(0.5, 0.3, 0).cross(Vec<3>(0, 0, -weight)), 1e-8);
    const Vec<3> onWall(1e4 * 0.6 * 0.125, 0, 0);
    expectVector(force("right", "force"), 1, onWall, 1e-8);
    expectVector(force("right", "moment"), 1, Vec<3>(1, 0.3, 0.5 / 3).cross(onWall), 1e-8);
    expectVector(force("left", "force"), 1, -onWall, 1e-8);
    expectVector(force("sides", "force"), 1, {0, 0, 0}, 1e-8);
    expectVector(force("floor left right sides", "force"), 1, {0, 0, -weight}, 1e-8);
}

// From the solver at rest, remeshed each step.
TEST(InSpace, ForcesOfWaterAtRest) {
    TestCase3 c = boxOfWater({1, 0.6, 0.5}, {1, 0.6, 0.8}, 0.1);
    c.start(1e-3);
    for (int k = 0; k < 5; ++k) c.step(1e-3);
    const FluidForce force = fluidForce<3>(c.problem, c.state, {0}, {});
    EXPECT_NEAR((force.pressure.force - Vec<3>(0, 0, -9.81 * 300)).norm(), 0, 1e-4 * weight);
    EXPECT_NEAR(force.viscous.force.norm(), 0, 1e-6 * weight);
}

// m U^2/2 and - m g . x; turning about z omega^2 m (a^2 + b^2)/6 (masses at the nodes: 1 %); no dissipation.
TEST(InSpace, EnergyOfARigidMotion) {
    const auto energy = [](const std::function<Vec<3>(const Vec<3>&)>& v) {
        State<3> state = tank3(0.05, 0);
        for (int i = 0; i < state.nodes.size(); ++i) state.nodes.v[i] = v(state.nodes.x[i]);
        auto functions = tankFolder().functions<3>("e { type energy; }");
        functions.start(state);
        state.time = {0.1, 1, 0.1, 0.1};
        functions.execute(state);
        return tankFolder().rows("e/0/energy.dat").back();
    };
    const auto moved = energy([](const Vec<3>&) { return Vec<3>(1, 2, -3); });
    EXPECT_NEAR(moved[1] / (0.5 * 300 * 14), 1, 1e-5);  // compression
    EXPECT_NEAR(moved[3] / (300 * 10 * 0.25), 1, 1e-5);
    EXPECT_NEAR(moved[5], 0, 1e-9);
    const auto turned = energy([](const Vec<3>& x) { return Vec<3>(0, 0, 4).cross(x); });
    EXPECT_NEAR(turned[1] / (16 * 300 * (1 + 0.36) / 6), 1, 0.01);
    EXPECT_NEAR(turned[5], 0, 1e-9);
}

TEST(InSpace, LineThroughHydrostaticPressure) {
    State<3> state = tank3();
    for (int i = 0; i < state.nodes.size(); ++i)
        state.nodes.v[i] = {3 * state.nodes.x[i][0], state.nodes.x[i][1], -state.nodes.x[i][2]};
    auto functions =
        tankFolder().functions<3>("l { type line; fields (p U); start (0.2 0.1 0.1); end (0.6 0.5 0.7); nPoints 5; }");
    functions.start(state);
    const auto rows = tankFolder().rows("l/0/line_p_U.xy");
    ASSERT_EQ(rows.size(), 5u);
    for (int k = 0; k < 5; ++k) {
        const Vec<3> x(0.2 + 0.1 * k, 0.1 + 0.1 * k, 0.1 + 0.15 * k);
        const bool in = x[2] < 0.5;
        EXPECT_NEAR(rows[k][0], (x - Vec<3>(0.2, 0.1, 0.1)).norm(), 1e-9);
        expectVector(rows[k], 1, x, 1e-9);
        EXPECT_NEAR(rows[k][4], in ? 1e4 * (0.5 - x[2]) : dry, 1e-6);
        expectVector(rows[k], 5, in ? Vec<3>(3 * x[0], x[1], -x[2]) : Vec<3>::Constant(dry), 1e-9);
    }
}

TEST(InSpace, ProbesAndExtremes) {
    State<3> state = tank3(0.1, 0);
    for (int i = 0; i < state.nodes.size(); ++i) {
        state.nodes.v[i] = state.nodes.x[i];
        if ((state.nodes.x[i] - Vec<3>(0.3, 0.2, 0.4)).norm() < 1e-9) state.nodes.p[i] = -3;
    }
    auto functions = tankFolder().functions<3>(
        "p { type probes; fields (p U); probeLocations ((0.33 0.21 0.17) (0.5 0.3 0.7)); }"
        "m { type fieldMinMax; fields (p); }");
    functions.start(state);
    const auto p = tankFolder().rows("p/0/p").at(0), U = tankFolder().rows("p/0/U").at(0);
    EXPECT_NEAR(p.at(1), 3300, 1e-7);
    EXPECT_EQ(p.at(2), dry);
    expectVector(U, 1, {0.33, 0.21, 0.17}, 1e-9);
    EXPECT_NE(tankFolder().text("p/0/p").find("(0.33 0.21 0.17)"), std::string::npos);
    const std::string extremes = tankFolder().text("m/0/fieldMinMax.dat");
    EXPECT_NE(extremes.find("\n0\tp\t-3\t(0.3 0.2 0.4)\t5000\t(0 0 0)\n"), std::string::npos) << extremes;
}

TEST(InSpace, FrontAndBox) {
    State<3> state = tank3();
    const auto up = row("f { type front; direction (0 0 3); }", state, "f/0/front.dat");
    EXPECT_NEAR(up.at(1), 0.5, 1e-12);
    EXPECT_NEAR(up.at(5), 0.5, 1e-12);
    EXPECT_NEAR(readFront<3>(state, Vec<3>(1, 1, 1).normalized())->connected, 2.1 / std::sqrt(3), 1e-12);
    state.nodes.dropVolume[0] = 1e-6;
    state.nodes.x[0] = {0.5, 0.3, 9};
    const auto box = row("b { type boundingBox; }", state, "b/0/boundingBox.dat");
    expectVector(box, 1, {0, 0, 0}, 1e-12);
    expectVector(box, 4, {1, 0.6, 9}, 1e-12);
    EXPECT_EQ(box.at(7), dry);
}

// What is in the tables sums up to the volume that there is.
TEST(InSpace, MassLedger) {
    State<3> state = tank3();
    auto functions = tankFolder().functions<3>("l { type massLedger; }");
    functions.start(state);
    for (auto& x : state.nodes.x) x[2] *= 1.001;
    state.ledger.takeFrom({{"solver", 1e-3 * 0.3}});
    state.time = {0.1, 1, 0.1, 0.1};
    functions.execute(state);
    const auto rows = tankFolder().rows("l/0/fluidVolume.dat");
    EXPECT_NEAR(rows.at(0).at(1), 0.3, 1e-9);
    EXPECT_NEAR(rows.at(0).at(2), 300, 1e-6);
    EXPECT_NEAR(rows.at(1).at(1), 0.3003, 1e-9);
    EXPECT_NEAR(rows.at(1).at(3), 1e-3, 1e-9);
    EXPECT_NEAR(rows.at(1).back(), 0, 1e-12);
}

}  // namespace pfem
