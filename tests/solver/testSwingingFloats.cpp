// Floats let go out of their rest swing as linear potential theory says: heave of a cylinder, roll of a barge.

#include <gtest/gtest.h>

#include "conditions/rigidBodies.hpp"
#include "support/potentialTheory.hpp"
#include "support/solids.hpp"
#include "walls/skins.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, halfWidth = 1.5, depth = 0.8;  // of the tank
constexpr double dt = 4e-3;
enum Motion { sway, heave, roll };

/// First two zero crossings and first two extremes of a swing, over its first value.
struct Swing {
    std::vector<double> zero, extreme;

    explicit Swing(const std::vector<double>& y) {
        for (std::size_t k = 1; k + 1 < y.size(); ++k) {
            const double t = static_cast<double>(k) * dt, slope = 0.5 * (y[k + 1] - y[k - 1]) / y[0];
            const double bend = (y[k + 1] - 2 * y[k] + y[k - 1]) / y[0];
            if (y[k] * y[k + 1] < 0) zero.push_back(t + dt * y[k] / (y[k] - y[k + 1]));
            if ((y[k] - y[k - 1]) * (y[k + 1] - y[k]) < 0) extreme.push_back(y[k] / y[0] - 0.5 * slope * slope / bend);
        }
    }
    double halfPeriod() const { return zero.at(1) - zero.at(0); }
};

/// The outline of a float in its first place: vertices from the left water line along the bottom to the right one and
/// back above the water; arcs in two words of the outlines of float and water.
struct Outline {
    Points<2> below, above;
    std::string arcs, arcOfWater;
};

std::string listOf(const Points<2>& points) {
    std::string text;
    for (const auto& p : points) text += point(p[0], p[1]);
    return text;
}

/// A float of half the water's density, with water that slides over it; `h`: beside it, elsewhere 50 mm.
TestCase floating(const Outline& f, double h) {
    Points<2> water(f.below.rbegin(), f.below.rend()), hull = f.below;
    water.insert(water.begin(), {Vec<2>(-halfWidth, -depth), Vec<2>(halfWidth, -depth), Vec<2>(halfWidth, 0)});
    water.emplace_back(-halfWidth, 0);
    hull.insert(hull.end(), f.above.begin(), f.above.end());
    std::string edges;
    for (std::size_t k = 0; k < hull.size(); ++k)
        edges += "(" + std::to_string(k) + " " + std::to_string((k + 1) % hull.size()) + ") ";
    const std::string size = "meshSize " + std::to_string(h) + "; ";
    TestCase c = makeCase(
        "meshSize 0.05; bodies ( water { type fluid; material water; vertices (" + listOf(water) + "); edges (" +
            f.arcOfWater + "); } hull { type solid; material wood; " + size + "vertices (" + listOf(hull) +
            "); edges (" + f.arcs + "); patches { skin { edges (" + edges + "); } } } ); walls ( tank { points (" +
            listOf({{-halfWidth, 0.3}, {-halfWidth, -depth}, {halfWidth, -depth}, {halfWidth, 0.3}}) +
            "); } ); refinements { waterLine { type box; min (-0.25 -0.04); max (0.25 0.02); " + size + "} }",
        pfem::test::water + "wood { type rigid; rho 500; }", "tank { type slip; } skin { type slipInterface; }",
        {0, -g});
    separateFromSkins<2>(c.kinds(), c.state);
    return c;
}

Swing computed(TestCase& c, Motion motion, double start, double time) {
    std::vector<double> y;
    c.start(dt);
    int rejected = 0;
    while (c.state.time.value < time) {
        const auto pose = rigidBodies<2>(c.problem, c.state.mesh, c.state.nodes).at(0).pose;
        y.push_back(motion == heave ? pose.at[1] : start + std::atan2(pose.turn(1, 0), pose.turn(0, 0)));
        rejected += c.step(dt).rejected;
    }
    EXPECT_EQ(rejected, 0);
    EXPECT_NEAR(y[0], start, 1e-2 * start);
    return Swing(y);
}

Swing predicted(const FloatTheory& theory, Motion motion, const FloatTheory::Motion& mass,
                const FloatTheory::Motion& stiffness, double time) {
    std::vector<double> y;
    for (const auto& place : theory.released(mass.asDiagonal(), stiffness.asDiagonal(), {0, 0},
                                             FloatTheory::Motion::Unit(motion), dt, static_cast<int>(time / dt)))
        y.push_back(place[motion]);
    return Swing(y);
}

void expectSamePeriod(const Swing& seen, const Swing& theory) {
    std::cout << "zeros " << seen.zero.at(0) << " " << seen.zero.at(1) << " (" << theory.zero.at(0) << " "
              << theory.zero.at(1) << "), first extreme " << seen.extreme.at(0) << " (" << theory.extreme.at(0)
              << ")\n";
    EXPECT_NEAR(seen.halfPeriod(), theory.halfPeriod(), 0.03 * theory.halfPeriod());
}

// Half submerged. In deep water; no wave comes back from the walls in time: Maskell and Ursell (1970).
TEST(SwingingFloats, heaveOfACylinder) {
    const double a = 0.1, lift = 0.02, x = std::sqrt(a * a - lift * lift), time = 0.88;
    const std::string bottom = point(0, lift - a);
    TestCase c = floating(
        {{{-x, 0}, {x, 0}}, {}, "arc 0 1 " + bottom + "arc 1 0 " + point(0, lift + a), "arc 3 4 " + bottom}, 6.25e-3);
    const Swing seen = computed(c, heave, lift, time);
    Points<2> section;
    for (int k = 0; k <= 60; ++k) section.emplace_back(-a * std::cos(M_PI * k / 60), -a * std::sin(M_PI * k / 60));
    section.front()[1] = section.back()[1] = 0;
    const FloatTheory theory(section, halfWidth, depth, M_PI * a / 60);
    const double mass = 500 * M_PI * a * a;
    EXPECT_NEAR(theory.addedMass({0, 0}, 1000)(heave, heave), mass, 0.02 * mass);  // at high frequencies (Ursell)
    const Swing wanted = predicted(theory, heave, {mass, mass, 1}, {0, 1000 * g * 2 * a, 0}, time);
    expectSamePeriod(seen, wanted);
    EXPECT_NEAR(seen.zero[0], wanted.zero[0], 0.01 * wanted.zero[0]);
    for (const std::size_t k : {0U, 1U})
        EXPECT_NEAR(seen.extreme.at(k), wanted.extreme.at(k), 0.03 * std::abs(wanted.extreme.at(k)));
}

// Eddies behind its edges take more from a roll than waves do: its period alone is that of potential theory.
TEST(SwingingFloats, rollOfABarge) {
    const double B = 0.3, draft = 0.1, angle = 5 * M_PI / 180, y = B / 2 * std::tan(angle), time = 1.3;
    const auto at = [&](double along, double up) { return Vec<2>(Eigen::Rotation2Dd(angle) * Vec<2>(along, up)); };
    TestCase c = floating({{at(-B / 2, y), at(-B / 2, -draft), at(B / 2, -draft), at(B / 2, -y)},
                           {at(B / 2, draft), at(-B / 2, draft)},
                           "",
                           ""},
                          6.25e-3);
    c.controls.momentum.mass = "consistent";
    const Swing seen = computed(c, roll, angle, time);
    Points<2> section;
    const auto side = [&](const Vec<2>& from, const Vec<2>& to, int n) {  // finer at its ends
        for (int k = 0; k < n; ++k) section.push_back(from + (to - from) * (0.5 - 0.5 * std::cos(M_PI * k / n)));
    };
    side({-B / 2, 0}, {-B / 2, -draft}, 20);
    side({-B / 2, -draft}, {B / 2, -draft}, 60);
    side({B / 2, -draft}, {B / 2, 0}, 20);
    section.emplace_back(B / 2, 0);
    const FloatTheory theory(section, halfWidth, depth, 5e-3);
    const double mass = 500 * B * 2 * draft, inertia = mass * (B * B + 4 * draft * draft) / 12;
    const double metacentric = B * B / (12 * draft) - draft / 2;  // height over the centre of mass
    expectSamePeriod(seen,
                     predicted(theory, roll, {mass, mass, inertia}, {0, 1000 * g * B, mass * g * metacentric}, time));
}

}  // namespace
