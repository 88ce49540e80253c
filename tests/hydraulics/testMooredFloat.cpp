// A moored barge in the waves of a piston moves as linear potential theory says of the same flume.

#include <gtest/gtest.h>

#include "conditions/rigidBodies.hpp"
#include "support/flume.hpp"
#include "support/potentialTheory.hpp"
#include "walls/skins.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double g = 9.81, halfLength = 3, d = 0.3, B = 0.3, draft = 0.1;  // of the flume; of the barge [m]
constexpr double T = 1.25, omega = 2 * M_PI / T, amplitude = 0.008;        // of the piston; k d is 1
constexpr double line = 200, mass = 500 * B * 2 * draft, dt = T / 60;      // stiffness of the mooring line [N/m]
constexpr int periods = 6, fitted = 2;

/// The barge in the middle of the flume; water slides over it, and it does not roll.
TestCase moored() {
    const double h = 0.03, fine = 0.0125;
    TestCase c = makeCase(
        numbers("meshSize %; bodies ( water { type fluid; material water; vertices ((-3 -0.3) (3 -0.3) (3 0) (0.15 0) "
                "(0.15 -0.1) (-0.15 -0.1) (-0.15 0) (-3 0)); } barge { type solid; material wood; meshSize %; vertices "
                "((-0.15 0) (-0.15 -0.1) (0.15 -0.1) (0.15 0) (0.15 0.1) (-0.15 0.1)); patches { hull { edges ((0 1) "
                "(1 2) (2 3) (3 4) (4 5) (5 0)); } } } ); walls ( piston { moving true; points ((-3 0.3) (-3 -0.3)); } "
                "tank { points ((-3.1 -0.3) (3 -0.3) (3 0.3)); } ); refinements { waterLine { type box; min (-0.25 "
                "-0.04); max (0.25 0.02); meshSize %; } }",
                {h, fine, fine}),
        water + numbers("wood { type rigid; rho 500; constraints { upright { type orientation; } } restraints { line { "
                        "type linearSpring; anchor (2 0 0); refAttachmentPt (0 0 0); stiffness %; restLength 2; } } }",
                        {line}),
        numbers("tank { type slip; } hull { type slipInterface; } piston { type slip; motion { displacement { type "
                "sine; frequency %; amplitude table ((0 0) (% 1)); scale (% 0 0); } } }",
                {1 / T, 2 * T, amplitude}),
        {0, -g});
    separateFromSkins<2>(c.kinds(), c.state);
    c.controls.momentum.mass = "consistent";
    return c;
}

double pistonVelocity(double t) {
    const double part = std::min(1.0, t / (2 * T)), growth = t < 2 * T ? 1 / (2 * T) : 0;
    return amplitude * (growth * std::sin(omega * t) + part * omega * std::cos(omega * t));
}

/// Amplitude and phase of the last periods.
std::complex<double> lastWaves(const std::vector<Vec<2>>& place, int direction) {
    const int n = static_cast<int>(std::lround(fitted * T / dt)), first = static_cast<int>(place.size()) - n;
    std::complex<double> sum = 0;
    for (int k = first; k < first + n; ++k)
        sum += 2.0 / n * place[static_cast<std::size_t>(k)][direction] * std::polar(1.0, -omega * k * dt);
    return sum;
}

TEST(MooredFloat, movesInWavesAsPotentialTheorySays) {
    TestCase c = moored();
    c.start(dt);
    std::vector<Vec<2>> seen;
    int rejected = 0;
    while (c.state.time.value < periods * T - 0.5 * dt) {
        seen.push_back(rigidBodies<2>(c.problem, c.state.mesh, c.state.nodes).at(0).pose.at);
        rejected += c.step(dt).rejected;
    }
    Points<2> section;
    const auto side = [&](const Vec<2>& from, const Vec<2>& to, int n) {  // finer at its ends
        for (int k = 0; k < n; ++k) section.push_back(from + (to - from) * (0.5 - 0.5 * std::cos(M_PI * k / n)));
    };
    side({-B / 2, 0}, {-B / 2, -draft}, 16);
    side({-B / 2, -draft}, {B / 2, -draft}, 40);
    side({B / 2, -draft}, {B / 2, 0}, 16);
    section.emplace_back(B / 2, 0);
    const FloatTheory theory(section, halfLength, d, 8e-3, 1.01);
    const Eigen::Vector3d masses(mass, mass, 1e9), stiffness(line, 1000 * g * B, 0);
    std::vector<Vec<2>> wanted;
    for (const auto& place : theory.inWaves(masses.asDiagonal(), stiffness.asDiagonal(), {0, 0}, pistonVelocity, dt,
                                            static_cast<int>(seen.size()) - 1))
        wanted.emplace_back(place[0], place[1]);
    EXPECT_LT(rejected, 0.02 * static_cast<double>(seen.size()));
    for (const int direction : {0, 1}) {
        const auto ratio = lastWaves(seen, direction) / lastWaves(wanted, direction);
        std::cout << (direction == 0 ? "sway" : "heave") << ": amplitude " << 1e3 * std::abs(lastWaves(seen, direction))
                  << " mm, of theory " << std::abs(ratio) << ", phase " << std::arg(ratio) << "\n";
        EXPECT_GT(std::abs(lastWaves(wanted, direction)), 0.003);
        EXPECT_NEAR(std::abs(ratio), 1, 0.05);
        EXPECT_NEAR(std::arg(ratio), 0, 0.1);
    }
}

}  // namespace
