// A stream keeps its momentum, though nodes come and go in it (remeshing, keepMomentum).

#include <gtest/gtest.h>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// Of the cells, along the stream, over rho.
double momentumOf(const State<2>& state) {
    double sum = 0;
    for (const auto& cell : state.mesh.fluid.nodes)
        for (const int i : cell) sum += simplexMeasure<2>(state.nodes.x, cell) / 3 * state.nodes.v[i][0];
    return sum;
}

/// A jet between waters at rest that flows through a finer zone, periodic, with nothing that could hold it: the part of
/// its momentum that is lost.
double lostInAJet(bool keep) {
    TestCase c = makeCase("meshSize 0.1; holdSizes yes; bodies ( water { type fluid; material water; " +
                              rectangle(0, 0, 2, 0.6) +
                              " velocity expression (\"exp(-60*(y - 0.3)^2)\" \"0\"); } ); walls ( floor { points ((-1 "
                              "0) (3 0)); } lid { points ((3 0.6) (-1 0.6)); } );"
                              "refinements { zone { type box; min (0.8 0); max (1.2 0.6); meshSize 0.04; } }",
                          water, "floor { type slip; } lid { type slip; }", {0, 0});
    c.problem.period.length[0] = 2;
    c.controls.remeshing.keepMomentum = keep;
    c.start(0.01);
    const double first = momentumOf(c.state);
    int removed = 0;
    while (c.state.time.value < 2) removed += c.step(0.02).mesh.removed;
    EXPECT_GT(removed, 100);
    return 1 - momentumOf(c.state) / first;
}

TEST(KeptMomentum, ofAJetThroughAFinerZone) {
    const double without = lostInAJet(false), with = lostInAJet(true);
    std::cout << "lost: " << without << ", with keepMomentum " << with << "\n";
    EXPECT_LT(std::abs(with), 0.2 * std::abs(without));
}

}  // namespace
