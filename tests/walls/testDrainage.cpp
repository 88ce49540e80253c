// Water runs off solids that rise out of it, over edges of type slipInterface.

#include <gtest/gtest.h>

#include "support/cases.hpp"
#include "walls/skins.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Mean of the solid's nodes and the volume of water over it [m2]: cells and drops whose centres, seen from the solid
/// as it stood at the start, are between its sides and over its top.
struct Load {
    Vec<2> centre = Vec<2>::Zero();
    double volume = 0;
};
Load loadOf(const TestCase& c) {
    const auto& nodes = c.state.nodes;
    const auto inSolid = nodesIn<2>(c.state.mesh.solid.nodes, nodes.size());
    Load load;
    Vec<2> low(1e9, 1e9), high = -low, before = Vec<2>::Zero();
    int count = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        if (!inSolid[i]) continue;
        load.centre += nodes.x[i];
        before += nodes.X[i];
        low = low.cwiseMin(nodes.X[i]).eval();
        high = high.cwiseMax(nodes.X[i]).eval();
        ++count;
    }
    load.centre /= count;
    before /= count;
    double sine = 0, cosine = 0;  // of its turn
    for (int i = 0; i < nodes.size(); ++i) {
        if (!inSolid[i]) continue;
        const Vec<2> r = nodes.X[i] - before, s = nodes.x[i] - load.centre;
        sine += r[0] * s[1] - r[1] * s[0];
        cosine += r.dot(s);
    }
    Tensor<2> back;
    back << cosine, sine, -sine, cosine;
    back /= std::hypot(sine, cosine);
    const auto isOver = [&](const Vec<2>& x) {
        const Vec<2> place = before + back * (x - load.centre);
        return place[0] > low[0] && place[0] < high[0] && place[1] > high[1] - 1e-9;
    };
    for (const auto& cell : c.state.mesh.fluid.nodes)
        if (isOver(simplexCentroid<2>(nodes.x, cell))) load.volume += simplexMeasure<2>(nodes.x, cell);
    for (int i = 0; i < nodes.size(); ++i)
        if (nodes.dropVolume[i] > 0 && isOver(nodes.x[i])) load.volume += nodes.dropVolume[i];
    return load;
}

/// One step of the length that the solver would take, at most `most`.
void advance(TestCase& c, double most) {
    const CourantRate rate = courantRate<2>(c.state);
    c.step(1 / std::max({1 / most, rate.largest / 0.4, rate.relative / 0.2, rate.compression / 0.7}));
}

// A plate of four triangles is lifted out of water at 0.5 m/s: within 2 s what it has lifted runs off.
TEST(Drainage, ofAPlateThatIsLifted) {
    TestCase c = makeCase(
        "meshSize 0.005; bodies ( water { type fluid; material water; " + rectangle(-0.1, 0, 0.1, 0.08) +
            " holes (plate); } plate { type solid; material body; " + rectangle(-0.03, 0.03, 0.03, 0.05) +
            " patches { base { edges ((0 1)); } skin { edges ((1 2) (2 3) (3 0)); } } } ); walls ( tank { points "
            "((-0.1 0.4) (-0.1 0) (0.1 0) (0.1 0.4)); } );",
        water + "body { type rigid; rho 2000; }",
        "tank { type slip; } skin { type slipInterface; } base { type clamped; motion { displacement table ((0 (0 0 "
        "0)) (0.3 (0 0.15 0)) (9 (0 0.15 0))); } }");
    separateFromSkins<2>(c.kinds(), c.state);
    c.start(5e-4);
    while (c.state.time.value < 0.1) advance(c, 2e-3);  // its underside passes where the level was
    const double lifted = loadOf(c).volume;
    while (c.state.time.value < 2.1) advance(c, 2e-3);
    const double left = loadOf(c).volume;
    std::cout << "lifted " << lifted << " m2, left " << left << " m2: " << 100 * left / lifted << " %\n";
    EXPECT_GT(lifted, 0.06 * 0.005);
    EXPECT_LT(left, 0.05 * lifted);
}

struct Ascent {
    double centre, level, left;  // of the block in the last second and at rest [m], on it at the end [m2]
};

/// A block of 49 x 24 mm comes up from the floor of a tank within 2 s, whose first step is of this length.
Ascent ascent(double w, double first) {
    const double b = 0.024, gap = 0.004, depth = 0.052, rho = 800.52;
    TestCase c = makeCase(
        "meshSize 0.004; bodies ( water { type fluid; material water; " + rectangle(-0.07, 0, 0.07, depth) +
            " holes (block); } block { type solid; material body; " + rectangle(-w, gap, w, gap + b) +
            " patches { skin { edges ((0 1) (1 2) (2 3) (3 0)); } } } ); walls ( tank { points ((-0.07 0.2) (-0.07 0) "
            "(0.07 0) (0.07 0.2)); } );",
        water + "body { type rigid; rho 800.52; }", "tank { type slip; } skin { type slipInterface; }");
    separateFromSkins<2>(c.kinds(), c.state);
    const double level = depth - 2 * w * b * (1 - rho / 1000) / 0.14;
    c.start(5e-4);
    c.step(first);
    double time = 0, sum = 0;
    while (c.state.time.value < 2) {
        const double before = c.state.time.value;
        advance(c, 2e-3);
        if (before < 1) continue;
        time += c.state.time.value - before;
        sum += loadOf(c).centre[1] * (c.state.time.value - before);
    }
    return {sum / time, level + b / 2 - b * rho / 1000, loadOf(c).volume};
}

// The block would float 1.5 mm too deep with what it has lifted. What stays on it are drops, and which ones is chance:
// 0 to 7 % of the layer for first steps that differ little. So their mean counts.
TEST(Drainage, ofABlockThatComesUp) {
    const double w = 0.0245, layer = 2 * w * 0.004;
    double left = 0;
    for (const double first : {4e-4, 5e-4, 6e-4}) {
        const Ascent block = ascent(w, first);
        std::cout << "centre " << 1e3 * block.centre << " mm, at rest " << 1e3 * block.level << " mm, left "
                  << block.left << " m2\n";
        EXPECT_NEAR(block.centre, block.level, 0.5e-3);
        left += block.left / 3;
    }
    EXPECT_LT(left, 0.05 * layer);
}

}  // namespace
