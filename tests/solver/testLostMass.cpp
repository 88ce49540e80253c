// Momentum of water that the account of volume says is too much: `momentum { lostMass yes; }`.

#include <gtest/gtest.h>

#include "periodicCases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// sum (Omega + lost) v along x of the nodes that are no images.
double momentumOfWater(const State<2>& state) {
    double sum = 0;
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell) sum += simplexMeasure<2>(state.nodes.x, cell) / 3 * state.nodes.v[i][0];
    for (int i = 0; i < nOwnNodes<2>(state); ++i) sum += state.nodes.lostVolume[i] * state.nodes.v[i][0];
    return sum;
}

/// A thick layer whose upper half moves and has this part of its volume too much, while the lower half rests; what its
/// momentum has become when they have mixed and most of the excess has gone, over that at the start.
double momentumKept(double excess, bool lostMass) {
    TestCase c =
        periodic(1.5,
                 "meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1.5, 0.5) +
                     " pattern crossed; cells (15 5); velocity expression (\"y > 0.25 ? 1 : 0\" \"0\"); } ); "
                     "walls ( floor { points ((-1 0) (3 0)); } );",
                 "water { type newtonian; rho 1000; mu 300; kappa 2.1e9; }", "floor { type slip; }", {0, -9.81});
    c.controls.momentum.lostMass = lostMass;
    c.controls.continuity.volumeReturnTime = 0.3;
    c.controls.remeshing.surfaceShift = 0;
    c.controls.continuity.volumeCorrectionTime = 0;
    c.start(0.01);
    std::vector<double> patch(c.state.nodes.size(), 0.0);
    for (const auto& cell : c.state.mesh.fluid.nodes)
        for (const int i : cell) patch[i] += simplexMeasure<2>(c.state.nodes.x, cell) / 3;
    for (int i = 0; i < nOwnNodes<2>(c.state); ++i)
        if (c.state.nodes.x[i][1] > 0.25) c.state.nodes.lostVolume[i] = -excess * patch[i];
    const double before = momentumOfWater(c.state);
    run(c, 0.6, 0.005);
    return momentumOfWater(c.state) / before;
}

TEST(LostMass, excessHasNoInertia) {
    const double none = momentumKept(0, false), kept = momentumKept(0.2, true), without = momentumKept(0.2, false);
    std::cout << "momentum of the water over the first: " << kept << ", without lostMass " << without
              << ", without excess " << none << "\n";
    EXPECT_NEAR(kept, none, 0.01);
    EXPECT_GT(without, none + 0.05);
}

}  // namespace
