// Sizes that belong to places in runs: water passes a zone of finer mesh, which stays as it is and makes no noise.

#include <gtest/gtest.h>

#include "state/volume.hpp"
#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

constexpr double fine = 0.04, coarse = 0.1;

/// Nodes of the fluid within the zone, and the mean length of the edges there in parts of the wanted one.
struct Zone {
    int nodes = 0;
    double edge = 0;
};
Zone zoneOf(const TestCase& c, const Vec<2>& low, const Vec<2>& high) {
    Zone zone;
    const auto isIn = [&](const Vec<2>& x) { return distanceToBox<2>(x, low, high) == 0; };
    const auto topology = c.topology();
    for (int i = 0; i < c.state.nodes.size(); ++i) zone.nodes += topology.ofFluid(i) && isIn(c.state.nodes.x[i]);
    int edges = 0;
    for (const auto& cell : c.state.mesh.fluid.nodes)
        for (int k = 0; k < 3; ++k) {
            const Vec<2>&a = c.state.nodes.x[cell[k]], &b = c.state.nodes.x[cell[(k + 1) % 3]];
            if (!isIn(0.5 * (a + b))) continue;
            zone.edge += (b - a).norm() / fine;
            ++edges;
        }
    zone.edge /= edges;
    return zone;
}

// A uniform stream, periodic, ten times through: nothing in it may be disturbed by nodes that come and go.
TEST(HeldSizes, streamPassesAFineZone) {
    TestCase c = makeCase("meshSize 0.1; holdSizes yes; bodies ( water { type fluid; material water; velocity (1 0); " +
                              rectangle(0, 0, 2, 0.6) +
                              " } ); walls ( floor { points ((-1 0) (3 0)); } lid { points ((3 0.6) (-1 0.6)); } );"
                              "refinements { zone { type box; min (0.8 0); max (1.2 0.6); meshSize 0.04; } }",
                          water, "floor { type slip; } lid { type slip; }", {0, 0});
    c.problem.period.length[0] = 2;
    c.controls.remeshing.insertDistance = 1.5;
    c.tolerance(1e-7);
    c.start(0.01);
    const Vec<2> low{0.8, 0}, high{1.2, 0.6};
    const Zone first = zoneOf(c, low, high);
    const double volume = totalVolume<2>(c.state);
    int steps = 0, changes = 0, least = first.nodes, most = 0;
    double nodes = 0, edge = 0;
    while (c.state.time.value < 20) {
        const auto report = c.step(0.02);
        if (c.state.time.value < 2) continue;  // the water of the start has passed
        const Zone now = zoneOf(c, low, high);
        ++steps;
        changes += report.mesh.inserted + report.mesh.removed;
        nodes += now.nodes;
        edge += now.edge;
        least = std::min(least, now.nodes);
        most = std::max(most, now.nodes);
    }
    nodes /= steps;
    std::cout << "nodes in the zone: first " << first.nodes << ", then " << nodes << " (" << least << " ... " << most
              << "), edges " << edge / steps << " of the wanted, first " << first.edge << "\n";
    EXPECT_NEAR(nodes, first.nodes, 0.1 * first.nodes);
    EXPECT_GT(least, 0.85 * nodes);
    EXPECT_LT(most, 1.15 * nodes);
    EXPECT_NEAR(edge / steps, 1, 0.07);
    EXPECT_GT(changes, 5 * steps);
    const auto points = c.topology().wallPoint;
    for (int i = 0; i < c.state.nodes.size(); ++i)
        EXPECT_LT(points[i] ? 0 : (c.state.nodes.v[i] - Vec<2>(1, 0)).norm(), 1e-9);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-10);
    EXPECT_NEAR(c.ledgerSum(), totalVolume<2>(c.state) - volume, 1e-11);
}

// Water at rest whose mesh is not what the zone asks for: nodes come, once, and nothing moves.
TEST(HeldSizes, stillWaterStaysStill) {
    TestCase c = makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                              " } ); walls ( tank { points ((0 0.8) (0 0) (1 0) (1 0.8)); } );",
                          water, "tank { type slip; }");
    c.tolerance(1e-9);
    c.start(0.01);
    c.state.sizes.coarsest = coarse;
    auto& place = c.state.sizes.places.emplace_back();
    place.meshSize = fine;
    place.box = {Vec<2>(0.3, 0), Vec<2>(0.6, 0.3)};
    const Zone before = zoneOf(c, {0.3, 0}, {0.6, 0.3});
    const double volume = totalVolume<2>(c.state);
    int last = 0;
    for (int n = 1; n <= 60; ++n) {
        const auto report = c.step(0.01);
        if (report.mesh.inserted + report.mesh.removed > 0) last = n;
        EXPECT_LT(largest(c.state.nodes.v), 1e-7) << n;
    }
    const Zone after = zoneOf(c, {0.3, 0}, {0.6, 0.3});
    std::cout << "nodes " << before.nodes << " -> " << after.nodes << ", edges " << before.edge << " -> " << after.edge
              << ", last change in step " << last << "\n";
    EXPECT_GT(after.nodes, 3 * before.nodes);
    EXPECT_NEAR(after.edge, 1, 0.25);
    EXPECT_LT(last, 30);
    EXPECT_NEAR(totalVolume<2>(c.state), volume, 1e-12);
}

}  // namespace
