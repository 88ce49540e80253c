// A duct of tetrahedra between an inlet and an outlet.

#include <gtest/gtest.h>

#include "mesher/openings.hpp"
#include "mesher/space/readSpaceDict.hpp"
#include "mesher/space/spaceMesher.hpp"
#include "state/volume.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double L = 1, B = 0.3, H = 0.4, U = 0.5, mu = 1;

/// Length L along x, width B, height H, full of a thick fluid that moves with `velocity`. `bed`: type of bed and lid;
/// `profile` of the inlet.
TestCase3 duct(const std::string& velocity, const std::string& bed, const std::string& profile) {
    const auto conditions =
        Dictionary::parse("bedAndLid { type " + bed + "; } sides { type slip; } inlet { type inlet; velocity 0.5; " +
                              profile + " } outlet { type outlet; pressure 0; }",
                          "boundaryConditions");
    auto description = readSpaceDict(
        Dictionary::parse("dimension 3; meshSize 0.1; geometry { tube { type box; min (0 0 0); max (1 0.3 0.4); } } "
                          "bodies { oil { type fluid; material oil; geometry tube; velocity " +
                              velocity +
                              "; } } walls { "
                              "bedAndLid { geometry tube; open (xMin xMax yMin yMax); } "
                              "sides { geometry tube; open (xMin xMax zMin zMax); } "
                              "inlet { geometry tube; open (xMax yMin yMax zMin zMax); } "
                              "outlet { geometry tube; open (xMin yMin yMax zMin zMax); } }",
                          "meshDict"),
        {"oil"}, "");
    markOpenings(conditions, description);
    TestCase3 c;
    c.state = buildSpaceMesh(description).state;
    c.problem.materials =
        readMaterials(Dictionary::parse("oil { type newtonian; rho 1; mu 1; kappa 1e7; }", "materials"));
    c.problem.conditions = readBoundaryConditions<3>(conditions, c.state.mesh.patches);
    c.start(0.01);
    return c;
}

/// What is there less what has come, but for what the nodes lack.
double account(const State<3>& state) {
    double lost = 0;
    for (const double one : state.nodes.lostVolume) lost += one;
    return totalVolume<3>(state) + lost - state.ledger.sum(CauseKind::passage) - state.ledger[VolumeCause::compression];
}

// Plane Poiseuille flow between slippery sides: slope of the pressure and speed in the middle.
TEST(OpeningsInSpace, poiseuilleFlowPasses) {
    TestCase3 c =
        duct("expression (\"3*z*(0.4 - z)/0.16\" \"0\" \"0\")", "noSlip", "profile expression; shape \"z*(0.4 - z)\";");
    const double first = account(c.state), volume = totalVolume<3>(c.state);
    for (int n = 0; n < 80; ++n) c.step(0.025);
    EXPECT_NEAR(c.state.ledger[VolumeCause::inflow], 2 * U * B * H, 1e-12);
    EXPECT_NEAR(account(c.state), first, 1e-12);
    EXPECT_NEAR(totalVolume<3>(c.state), volume, 0.01 * volume);
    double xx = 0, xp = 0, x1 = 0, p1 = 0, squares = 0;
    int count = 0;
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) {
        const auto& x = c.state.nodes.x[i];
        if (!topology.wet(i) || x[0] < 0.2 || x[0] > 0.8) continue;
        squares += std::pow(c.state.nodes.v[i][0] - 6 * U * x[2] * (H - x[2]) / (H * H), 2);
        xx += x[0] * x[0];
        xp += x[0] * c.state.nodes.p[i];
        x1 += x[0];
        p1 += c.state.nodes.p[i];
        ++count;
    }
    const double slope = (count * xp - x1 * p1) / (count * xx - x1 * x1), exact = -12 * mu * U / (H * H);
    EXPECT_NEAR(slope, exact, 0.1 * std::abs(exact));
    EXPECT_LT(std::sqrt(squares / count), 0.06 * 1.5 * U);
}

// A stream that nothing holds back, in a duct that slips all round. Nodes come and go, and arrive at the outlet beside
// its edges: each that is made there is held by the walls, and no face is open. A node without its wall left the duct,
// the faces around it were a free surface, and single nodes had pressures and velocities of their own.
TEST(OpeningsInSpace, uniformStreamStaysUniform) {
    TestCase3 c = duct("(0.5 0 0)", "slip", "");
    const Vec<3> size(L, B, H);
    double outside = 0, speed = 0, pressure = 0;
    for (int n = 0; n < 62; ++n) {
        if (n == 2) {  // as it comes in, so it began: also where it leaves
            EXPECT_LT(speed, 1e-11);
            EXPECT_LT(pressure, 1e-10);  // rho U^2 is 0.25
        }
        c.step(0.025);
        const auto topology = c.topology();
        for (const auto& face : topology.faces) ASSERT_GE(face.wall, 0) << c.state.time.value;
        for (int i = 0; i < c.state.nodes.size(); ++i) {
            if (!topology.wet(i)) continue;
            const auto& x = c.state.nodes.x[i];
            outside = std::max({outside, -x.minCoeff(), (x - size).maxCoeff()});
            speed = std::max(speed, (c.state.nodes.v[i] - Vec<3>(U, 0, 0)).norm());
            pressure = std::max(pressure, std::abs(c.state.nodes.p[i]));
        }
    }
    std::cout << "to " << c.state.time.value << " s: speed off by " << speed / U << " U, pressure " << pressure << "\n";
    EXPECT_LT(outside, 1e-12);
    EXPECT_LT(speed, 0.02 * U);
    EXPECT_LT(pressure, 0.5);  // mu U/h is 5 Pa
}

}  // namespace
