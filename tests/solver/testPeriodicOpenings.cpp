// Openings beside periodic sides: water comes and goes in one direction, in another it goes round.

#include <gtest/gtest.h>

#include "mesher/space/readSpaceDict.hpp"
#include "mesher/space/spaceMesher.hpp"
#include "periodicCases.hpp"
#include "state/volume.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A square of 1 m between sides in x: water comes in below and leaves above.
TestCase fountain(double h, const std::string& inlet, const Vec<2>& velocity) {
    TestCase c = periodic(1,
                          "meshSize " + std::to_string(h) + "; bodies ( water { type fluid; material water; " +
                              rectangle(0, 0, 1, 1) +
                              " } ); walls ( below { points ((-1 0) (2 0)); } above { points ((2 1) (-1 1)); } );",
                          "water { type newtonian; rho 1; mu 0.05; kappa 1e6; }",
                          "below { type inlet; " + inlet + " } above { type outlet; }", {0, 0});
    const auto kept = keptNodes<2>(c.state.mesh, c.state.nodes.size());
    for (int i = 0; i < c.state.nodes.size(); ++i)
        if (!kept[i]) c.state.nodes.v[i] = velocity;
    c.start(0.01);
    return c;
}

/// What is there less what has come, but for what the nodes lack.
template <int Dim>
double accountOf(const State<Dim>& state) {
    double lost = 0;
    for (int i = 0; i < nOwnNodes<Dim>(state); ++i) lost += state.nodes.lostVolume[i];
    return totalVolume<Dim>(state) + lost - state.ledger.sum(CauseKind::passage) -
           state.ledger[VolumeCause::compression];
}

// Nodes that come in go round as they rise.
TEST(PeriodicOpenings, obliqueStreamStaysUniform) {
    TestCase c = fountain(0.1, "velocity 1; direction (0.7 1 0);", {0.7, 1});
    const double volume = totalVolume<2>(c.state), first = accountOf<2>(c.state);
    EXPECT_NEAR(volume, 1, 1e-9);
    double speed = 0;
    int appeared = 0;
    for (int n = 0; n < 80; ++n) {
        appeared += c.step(0.02).mesh.inserted;
        const auto topology = c.topology();
        for (int i = 0; i < nOwnNodes<2>(c.state); ++i) {
            if (!topology.wet(i)) continue;
            speed = std::max(speed, (c.state.nodes.v[i] - Vec<2>(0.7, 1)).norm());
            EXPECT_GE(c.state.nodes.x[i][0], 0);
            EXPECT_LT(c.state.nodes.x[i][0], 1);
        }
    }
    EXPECT_GT(appeared, 100);
    EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 1.6, 1e-11);
    EXPECT_NEAR(accountOf<2>(c.state), first, 1e-12);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-4);
    std::cout << "speed off by " << speed << "\n";
    EXPECT_LT(speed, 1e-4);
}

// Water that rises faster here than there, and the same a third of the width farther.
TEST(PeriodicOpenings, flowsDoNotSeeTheSides) {
    double energy[2], across[2];
    for (const int n : {0, 1}) {
        const std::string shape = n == 0 ? "1 + 0.5*sin(2*pi*x)" : "1 + 0.5*sin(2*pi*(x - 0.3))";
        TestCase c =
            fountain(0.0625, "flowRate 1; profile expression; shape \"" + shape + "\"; direction (0.3 1 0);", {0.3, 1});
        energy[n] = across[n] = 0;
        for (int k = 0; k < 100; ++k) {
            c.step(0.01);
            if (k < 50) continue;
            for (const auto& cell : c.state.mesh.fluid.nodes)
                for (const int i : cell) {
                    const double part = simplexMeasure<2>(c.state.nodes.x, cell) / 3 / 50;
                    energy[n] += 0.5 * part * c.state.nodes.v[i].squaredNorm();
                    across[n] += part * c.state.nodes.v[i][0];
                }
        }
        EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 1, 1e-11);
        EXPECT_NEAR(totalVolume<2>(c.state), 1, 2e-3);
    }
    std::cout << "energy " << energy[0] << " and " << energy[1] << ", across " << across[0] << " and " << across[1]
              << "\n";
    EXPECT_GT(energy[0], 0.5 * (1 + 0.125));  // the stream keeps its shape
    EXPECT_NEAR(energy[0], energy[1], 0.005 * energy[0]);
    EXPECT_NEAR(across[0], across[1], 0.02 * across[0]);
}

TEST(PeriodicOpenings, refused) {
    const auto refusal = [](const std::string& inlet, const std::string& walls) {
        return refusalOf(
            makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 1) +
                         " } ); walls ( " + walls + " above { points ((2 1) (-1 1)); } );",
                     water, "below { type inlet; " + inlet + " } above { type outlet; }"),
            "x (0 1);");
    };
    const std::string below = "below { points ((-1 0) (2 0)); }";
    EXPECT_EQ(refusal("velocity 1;", below), "");
    EXPECT_NE(refusal("velocity 1; profile parabolic;", below).find("not the same at both periodic sides"),
              std::string::npos);
    EXPECT_EQ(refusal("velocity 1; profile expression; shape \"2 + cos(2*pi*x)\";", below), "");
    EXPECT_EQ(refusal("velocity 1; profile expression; shape \"sin(pi*x)^2\";", below), "");  // 0 at both, nearly
    EXPECT_NE(refusal("velocity 1;", "below { points ((0 0) (1 0)); }").find("ends at a periodic side"),
              std::string::npos);
    EXPECT_NE(refusal("velocity 1;", "below { points ((-1 -0.5) (2 -0.5)); }").find("no water wets the inlet"),
              std::string::npos);
}

/// Plane Poiseuille flow in space between bed and lid, between periodic sides or slippery walls: rms of what the
/// profile is off, in parts of the fastest velocity.
double channelError(bool isPeriodic) {
    constexpr double H = 0.4, B = 1.1, U = 0.5;
    const auto description = readSpaceDict(
        Dictionary::parse("dimension 3; meshSize 0.1; geometry { tube { type box; min (0 0 0); max (0.6 1.1 0.4); } "
                          "wide { type box; min (0 -0.7 0); max (0.6 1.8 0.4); } } "
                          "bodies { oil { type fluid; material oil; geometry tube; } } walls { "
                          "bedAndLid { geometry wide; open (xMin xMax yMin yMax); } "
                          "inlet { geometry wide; open (xMax yMin yMax zMin zMax); } "
                          "outlet { geometry wide; open (xMin yMin yMax zMin zMax); } " +
                              std::string(isPeriodic ? "" : "sides { geometry tube; open (xMin xMax zMin zMax); } ") +
                              "}",
                          "meshDict"),
        {"oil"}, "");
    TestCase3 c;
    c.state = buildSpaceMesh(description).state;
    const auto exact = [](double z) { return 6 * U * z * (H - z) / (H * H); };
    for (int i = 0; i < c.state.nodes.size(); ++i) c.state.nodes.v[i] = {exact(c.state.nodes.x[i][2]), 0, 0};
    c.problem.materials =
        readMaterials(Dictionary::parse("oil { type newtonian; rho 1; mu 1; kappa 1e7; }", "materials"));
    c.problem.conditions = readBoundaryConditions<3>(
        Dictionary::parse(
            (isPeriodic ? "" : "sides { type slip; } ") +
                std::string("bedAndLid { type noSlip; } inlet { type inlet; flowRate 0.22; profile expression; "
                            "shape \"z*(0.4 - z)\"; } outlet { type outlet; pressure 0; }"),
            "boundaryConditions"),
        c.state.mesh.patches);
    if (isPeriodic) c.problem.period.length = {0, B, 0};
    c.start(0.01);
    const double first = accountOf<3>(c.state), volume = totalVolume<3>(c.state);
    EXPECT_NEAR(volume, 0.6 * B * H, 1e-6);
    for (int n = 0; n < 16; ++n) c.step(0.025);
    EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 0.4 * U * B * H, 1e-12);
    EXPECT_NEAR(accountOf<3>(c.state), first, 1e-12);
    EXPECT_NEAR(totalVolume<3>(c.state), volume, 0.01 * volume);
    double squares = 0;
    int count = 0;
    const auto topology = c.topology();
    for (int i = 0; i < nOwnNodes<3>(c.state); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (!topology.wet(i) || x[0] < 0.15 || x[0] > 0.45) continue;
        const auto& v = c.state.nodes.v[i];
        squares += std::pow(v[0] - exact(x[2]), 2);
        ++count;
    }
    return std::sqrt(squares / count) / (1.5 * U);
}

TEST(PeriodicOpenings, channelInSpace) {
    const double error = channelError(true), betweenWalls = channelError(false);
    std::cout << "profile off by " << error << ", between slippery walls " << betweenWalls << "\n";
    EXPECT_LT(error, 1.2 * betweenWalls);
    EXPECT_LT(error, 0.08);
}

}  // namespace
