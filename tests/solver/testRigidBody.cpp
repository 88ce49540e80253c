// Bodies of `type rigid`: momentum and its moment, closed forms of constraints and restraints, floating.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "conditions/rigidBodies.hpp"
#include "support/cases.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

template <int Dim>
RigidBody<Dim> bodyOf(const Simulation<Dim>& c, int k = 0) {
    return rigidBodies<Dim>(c.problem, c.state.mesh, c.state.nodes).at(static_cast<std::size_t>(k));
}

template <int Dim>
void setTwist(Simulation<Dim>& c, const Twist<Dim>& twist) {
    const auto body = bodyOf<Dim>(c);
    for (std::size_t k = 0; k < body.nodes.size(); ++k)
        c.state.nodes.v[body.nodes[k]] = leverRows<Dim>(body.pose.lever(body.arm[k])) * twist;
}

/// Angular momentum about the centre of mass, in space.
Eigen::Vector3d spin(const RigidBody<3>& body) {
    return body.pose.turn * (body.inertia * (body.pose.turn.transpose() * body.twist.tail<3>()));
}

/// Largest change of a distance between nodes since the start, in parts of it.
template <int Dim>
double distortion(const Simulation<Dim>& c) {
    const auto body = bodyOf<Dim>(c);
    const auto& nodes = c.state.nodes;
    double worst = 0;
    for (const int i : body.nodes)
        for (const int j : body.nodes)
            if (i != j) {
                const double length = (nodes.X[i] - nodes.X[j]).norm();
                worst = std::max(worst, std::abs((nodes.x[i] - nodes.x[j]).norm() - length) / length);
            }
    return worst;
}

TestCase block(const std::string& entries, const Vec<2>& gravity, const std::string& patches = "",
               const std::string& conditions = "") {
    return makeCase("meshSize 0.1; bodies ( block { type solid; material iron; " + rectangle(-0.2, -0.1, 0.2, 0.1) +
                        " patches { " + patches + " } } );",
                    "iron { type rigid; rho 500; " + entries + " }", conditions, gravity);
}

TEST(RigidBody, massAndInertiaOfTheMeshOrAsGiven) {
    const auto body = bodyOf<2>(block("", {0, 0}));
    EXPECT_NEAR(body.mass, 40, 1e-10);
    EXPECT_NEAR(body.inertia(2, 2), 40 * (0.4 * 0.4 + 0.2 * 0.2) / 12, 1e-12);
    EXPECT_LT(body.pose.at.norm(), 1e-14);
    const auto given = bodyOf<2>(block("mass 3; momentOfInertia (0 0 0.5); centreOfMass (0.1 0 0);", {0, 0}));
    EXPECT_EQ(given.mass, 3);
    EXPECT_EQ(given.inertia(2, 2), 0.5);
    EXPECT_LT((given.pose.at - Vec<2>(0.1, 0)).norm(), 1e-14);
    EXPECT_THROW(block("mass -3;", {0, 0}), UserError);
    EXPECT_THROW(block("constraints { a { type pointt; } }", {0, 0}), UserError);
    EXPECT_THROW(block("restraints { a { type linearDamper; } }", {0, 0}), UserError);
}

TEST(RigidBody, freeFlightWithSpinIsExact) {
    TestCase c = block("", {0, -10});
    setTwist<2>(c, {2, 1, 7});
    const double dt = 0.05;
    c.start(dt);
    for (int n = 0; n < 200; ++n) ASSERT_EQ(c.step(dt).rejected, 0);
    const auto body = bodyOf<2>(c);
    EXPECT_NEAR(body.twist[2], 7, 7e-11);
    EXPECT_NEAR(body.twist[0], 2, 1e-10);
    EXPECT_NEAR(body.twist[1], 1 - 100, 1e-9);
    EXPECT_LT((body.pose.at - Vec<2>(20, 10 - 500)).norm(), 1e-8);
    EXPECT_NEAR(std::remainder(std::atan2(body.pose.turn(1, 0), body.pose.turn(0, 0)) - 70, 2 * M_PI), 0, 1e-9);
    EXPECT_LT(distortion<2>(c), 1e-12);
}

TEST(RigidBody, inSpaceTheAngularMomentumStays) {
    TestCase3 c;
    c.state.mesh.materials = {"iron"};
    addLattice(c.state, c.state.mesh.solid, 0, {0, 0, 0}, {0.6, 0.4, 0.1}, 0.1);
    c.problem.materials = readMaterials(Dictionary::parse("iron { type rigid; rho 2000; }", "materials"));
    c.problem.gravity.setZero();
    c.controls.convergence.tolU = 1e-13;
    Twist<3> twist;
    twist << 1, -2, 0.5, 0.3, 6, 0.2;  // about the middle axis: it tumbles
    setTwist<3>(c, twist);
    const Eigen::Vector3d before = spin(bodyOf<3>(c));
    const double energy = 0.5 * before.dot(twist.tail<3>());
    c.start(0.01);
    double furthest = 1;
    for (int n = 0; n < 300; ++n) {
        ASSERT_EQ(c.step(0.01).rejected, 0);
        furthest = std::min(furthest, bodyOf<3>(c).pose.turn(1, 1));
    }
    const auto body = bodyOf<3>(c);
    EXPECT_LT((spin(body) - before).norm(), 1e-10 * before.norm());
    EXPECT_LT((body.twist.head<3>() - twist.head<3>()).norm(), 1e-10);
    EXPECT_NEAR(0.5 * spin(body).dot(body.twist.tail<3>()), energy, 5e-3 * energy);
    EXPECT_LT(furthest, -0.8);  // it has turned over
    EXPECT_LT(distortion<3>(c), 1e-12);
}

/// Period from the zero crossings of a quantity that swings about `mean`.
template <class Quantity>
double period(TestCase& c, double dt, int steps, double mean, const Quantity& quantity) {
    std::vector<double> crossings;
    double last = quantity(bodyOf<2>(c)) - mean;
    for (int n = 0; n < steps; ++n) {
        c.step(dt);
        const double now = quantity(bodyOf<2>(c)) - mean;
        if (last > 0 && now <= 0) crossings.push_back(c.state.time.value - dt * now / (now - last));
        last = now;
    }
    return crossings.size() < 2 ? 0
                                : (crossings.back() - crossings.front()) / (static_cast<double>(crossings.size()) - 1);
}

TEST(RigidBody, pendulumAboutAPoint) {
    TestCase c = block("centreOfRotation (0 0.1 0); constraints { hinge { type point; } }", {0, -10});
    setTwist<2>(c, {0, 0, 0.2});
    c.start(0.005);
    const double inertia = 40 * ((0.16 + 0.04) / 12 + 0.01), expected = 2 * M_PI * std::sqrt(inertia / (40 * 10 * 0.1));
    const double seen = period(c, 0.005, 800, 0, [](const auto& b) { return b.pose.turn(1, 0); });
    EXPECT_NEAR(seen, expected, 2e-3 * expected);
    EXPECT_LT((bodyOf<2>(c).pose.at - Vec<2>(0, 0.1)).norm(), 1e-13);  // the hinge stays where it is
}

/// The block goes up and down on a rope of 4000 N/m that is just straight; `more`: entries of the rope.
TestCase onARope(const std::string& more) {
    return block(
        "constraints { up { type line; direction (0 1 0); } stiff { type orientation; } }"
        "restraints { rope { type linearSpring; anchor (0 2 0); refAttachmentPt (0 0.1 0); stiffness 4000; "
        "restLength 1.9; " +
            more + " } }",
        {0, -10});
}

TEST(RigidBody, springsSwingAndDampersStop) {
    TestCase c = onARope("");
    setTwist<2>(c, {3, 0, 4});  // what constraints do not let be goes
    c.start(0.002);
    const double expected = 2 * M_PI * std::sqrt(40.0 / 4000);
    EXPECT_NEAR(period(c, 0.002, 1000, -0.1, [](const auto& b) { return b.pose.at[1]; }), expected, 2e-3 * expected);
    EXPECT_LT(std::abs(bodyOf<2>(c).pose.at[0]), 1e-13);
    TestCase d = block(
        "restraints { drag { type linearDamper; coeff 80; } turn { type sphericalAngularDamper; coeff 2; } }", {0, 0});
    setTwist<2>(d, {1, 0, 5});
    for (int n = 0; n < 100; ++n) d.step(0.005);
    EXPECT_NEAR(bodyOf<2>(d).twist[0], std::exp(-1.0), 1e-4);
    EXPECT_NEAR(bodyOf<2>(d).twist[2], 5 * std::exp(-2 * 0.5 / (40 * 0.2 / 12)), 1e-3);
    TestCase a = block("restraints { roll { type linearAxialAngularSpring; axis (0 0 1); stiffness 20; } }", {0, 0});
    setTwist<2>(a, {0, 0, 1});
    const double roll = 2 * M_PI * std::sqrt(40 * 0.2 / 12 / 20);
    EXPECT_NEAR(period(a, 0.005, 800, 0, [](const auto& b) { return b.pose.turn(1, 0); }), roll, 2e-3 * roll);
}

// Thrown up from where its line is just straight it flies for 2 v/g, then the line swings it back with the same speed.
TEST(RigidBody, aMooringLineDoesNotPush) {
    TestCase c = onARope("tensionOnly yes;");
    constexpr double v = 3, g = 10, omega = 10;
    setTwist<2>(c, {0, v, 0});
    c.start(0.002);
    const double expected = 2 * v / g + 2 / omega * (M_PI - std::atan(v * omega / g));
    EXPECT_NEAR(period(c, 0.002, 2000, 0.1, [](const auto& b) { return b.pose.at[1]; }), expected, 2e-3 * expected);
}

TEST(RigidBody, aClampedPatchPrescribesTheMotion) {
    TestCase c = block("", {0, -10}, "top { edges ((2 3)); }",
                       "top { type clamped; motion { velocity (1 0 0); omega 2; origin (0 0.1 0); } }");
    for (int n = 0; n < 50; ++n) ASSERT_EQ(c.step(0.01).rejected, 0);
    const auto body = bodyOf<2>(c);
    const Vec<2> expected = Vec<2>(0.5, 0.1) + Eigen::Rotation2Dd(1.0) * Vec<2>(0, -0.1);
    EXPECT_LT((body.pose.at - expected).norm(), 1e-12);
    EXPECT_NEAR(body.twist[2], 2, 1e-12);
    TestCase still = block("", {0, -10}, "top { edges ((2 3)); }", "top { type clamped; }");
    for (int n = 0; n < 5; ++n) still.step(0.01);
    EXPECT_LT((bodyOf<2>(still).pose.at).norm(), 1e-14);
}

TEST(RigidBody, symmetryLetsItSlideAndNotTurn) {
    TestCase c = block("", {3, -10}, "side { edges ((3 0)); }", "side { type symmetry; }");
    setTwist<2>(c, {0, 1, 3});
    for (int n = 0; n < 20; ++n) c.step(0.01);
    const auto body = bodyOf<2>(c);
    EXPECT_NEAR(body.twist[1], 1 - 2, 1e-11);
    EXPECT_LT(std::abs(body.pose.at[0]), 1e-13);
    EXPECT_NEAR(body.twist[2], 0, 1e-12);
}

/// A block of 0.1 x 0.1 m in its draft (in parts of its height) in a tank, free to heave.
TestCase floating(double density, double draft, double h, const std::string& entries = "",
                  const std::string& law = "rigid") {
    const auto n = [](double value) { return std::to_string(value); };
    const double bottom = 0.2 - 0.1 * draft, top = bottom + 0.1;
    const auto point = [&](double x, double y) { return "(" + n(x) + " " + n(y) + ") "; };
    return makeCase(
        "meshSize " + n(h) + "; bodies ( water { type fluid; material water; vertices (" + point(0, 0) + point(0.4, 0) +
            point(0.4, 0.2) + point(0.25, 0.2) + point(0.25, bottom) + point(0.15, bottom) + point(0.15, 0.2) +
            point(0, 0.2) + "); } block { type solid; material wood; vertices (" + point(0.15, bottom) +
            point(0.25, bottom) + point(0.25, 0.2) + point(0.25, top) + point(0.15, top) + point(0.15, 0.2) +
            "); } ); walls ( tank { points ((0 0.5) (0 0) (0.4 0) (0.4 0.5)); } );",
        water + "wood { type " + law + "; rho " + n(density) + "; " + entries + " }", "tank { type slip; }");
}

/// Steps of dt without one that is rejected; the most iterations that one took.
int mostIterations(TestCase& c, int steps, double dt) {
    c.start(dt);
    int most = 0;
    for (int n = 0; n < steps; ++n) {
        const auto report = c.step(dt);
        EXPECT_EQ(report.rejected, 0) << "step " << n;
        most = std::max(most, report.step.iterations);
    }
    return most;
}

class Floats : public testing::TestWithParam<double> {};

TEST_P(Floats, inTheDraftOfArchimedes) {
    const double density = GetParam();
    TestCase c = floating(density, density / 1000, 0.025);
    const int most = mostIterations(c, 150, 2e-3);
    const auto body = bodyOf<2>(c);
    const double rise = body.pose.place(body.centre)[1] - (0.25 - 0.1 * density / 1000);
    std::cout << "density " << density << ": rise " << rise << ", speed " << body.twist.norm() << ", iterations "
              << most << "\n";
    EXPECT_LT(std::abs(rise), 0.005 * 0.1 * density / 1000);
    EXPECT_LE(most, 12);
}

// However near to nothing a tolerance asks for: what pressures that balance leave is round-off.
TEST(RigidBody, aFloatAtRestConvergesWithAnyTolerance) {
    for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
        TestCase c = floating(500, 0.5, 0.025);
        c.tolerance(tolerance, 60);
        const int most = mostIterations(c, 50, 2e-3);
        std::cout << "tolerance " << tolerance << ": iterations " << most << ", twist " << bodyOf<2>(c).twist.norm()
                  << "\n";
        EXPECT_LE(most, 20);
    }
}

INSTANTIATE_TEST_SUITE_P(densities, Floats, testing::Values(100, 300, 500, 700, 900));

/// Iterations of the steps of dt, none rejected, in ascending order.
std::vector<int> iterationsOf(TestCase& c, int steps, double dt) {
    std::vector<int> all;
    c.start(dt);
    for (int n = 0; n < steps; ++n) {
        const auto report = c.step(dt);
        EXPECT_EQ(report.rejected, 0) << "step " << n;
        all.push_back(report.step.iterations);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// Let go below its draft it springs up and turns; a fixed one is in the same water, which runs to and fro.
TEST(RigidBody, aFloatOfAHundredthOfTheWatersDensityIsStable) {
    TestCase free = floating(10, 0.3, 0.025),
             fixed = floating(10, 0.3, 0.025, "constraints { held { type point; } upright { type orientation; } }");
    for (TestCase* c : {&free, &fixed}) c->problem.gravity = {2, -9.81};
    const auto ofFree = iterationsOf(free, 200, 1e-3), ofFixed = iterationsOf(fixed, 200, 1e-3);
    std::cout << "light float: rise " << bodyOf<2>(free).pose.at[1] - 0.22 << ", iterations " << ofFree[100]
              << " (median) " << ofFree.back() << " (most), of a fixed one " << ofFixed[100] << " " << ofFixed.back()
              << "\n";
    EXPECT_EQ(bodyOf<2>(fixed).twist.norm(), 0);
    EXPECT_LE(ofFree[100], ofFixed[100] + 2);
    EXPECT_LE(ofFree.back(), ofFixed.back() + 2);
}

// Viscosity in the matrix: the conjugate gradients meet the body's own unknowns.
TEST(RigidBody, aFloatTurnsInSyrup) {
    TestCase c = floating(500, 0.5, 0.025);
    c.problem.materials = readMaterials(
        Dictionary::parse("water { type newtonian; rho 1000; mu 50; } wood { type rigid; rho 500; }", "materials"));
    setTwist<2>(c, {0, 0, 2});
    const int most = mostIterations(c, 40, 2e-3);
    const auto body = bodyOf<2>(c);
    std::cout << "in syrup: turns with " << body.twist[2] << " rad/s, iterations " << most << "\n";
    EXPECT_LE(most, 15);
    EXPECT_LT(std::abs(body.twist[2]), 0.5);
    EXPECT_LT(std::abs(body.twist[0]), 0.1);
}

TEST(RigidBody, heavesAsAVeryStiffSolidDoes) {
    std::vector<double> rise;
    for (const std::string law : {"rigid", "hypoelastic"}) {
        TestCase c = floating(500, 0.8, 0.025, law == "rigid" ? "" : "E 1e8; nu 0.3;", law);
        c.start(1e-3);
        for (int n = 0; n < 100; ++n) ASSERT_EQ(c.step(1e-3).rejected, 0);
        const int node = nearestNode(c.state.nodes.X, {0.2, 0.17});
        rise.push_back(c.state.nodes.x[node][1] - c.state.nodes.X[node][1]);
    }
    std::cout << "rise rigid " << rise[0] << ", stiff " << rise[1] << "\n";
    EXPECT_GT(rise[0], 0.005);
    EXPECT_NEAR(rise[0], rise[1], 0.01 * rise[1]);
}

}  // namespace
