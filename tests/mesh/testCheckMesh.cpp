#include <gtest/gtest.h>

#include "mesh/checkMesh.hpp"
#include "support/cases.hpp"

namespace pfem {

using namespace test;

namespace {

MeshCheck<2> check(const TestCase& c) {
    return checkMesh<2>(c.state.mesh, c.topology(), c.state.nodes.x, c.state.nodes.h);
}

/// Water 1 x 0.5 with a solid on its right, on a floor.
TestCase pair() {
    return makeCase("meshSize 0.1; bodies ( water { type fluid; material water; " + rectangle(0, 0, 1, 0.5) +
                        " } block { type solid; material rubber; " + rectangle(1, 0, 1.5, 0.5) +
                        " patches { base { edges ((1 2)); } } } ); walls ( floor { points ((0 0) (1 0)); } );",
                    water + rubber, "base { type clamped; } floor { type slip; }");
}

}  // namespace

TEST(CheckMesh, SoundPair) {
    const TestCase c = pair();
    const MeshCheck<2> result = check(c);
    EXPECT_TRUE(result.faults.empty());
    EXPECT_TRUE(result.gaps.empty());
    EXPECT_NEAR(result.freeSurface, 1.5, 1e-9);
    EXPECT_NEAR(result.wetWalls, 1, 1e-9);
    EXPECT_NEAR(result.interface, 0.5, 1e-9);
    EXPECT_EQ(result.pieces, 1);
    EXPECT_GT(result.fluid.worst, 0.5);
}

TEST(CheckMesh, QualityOfKnownTriangles) {
    TestCase c = pair();
    c.state.nodes.resize(4);
    c.state.nodes.x = {{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}, {0, 1}};
    c.state.nodes.h.assign(4, 1.0);
    c.state.nodes.wall.assign(4, unsupported<2>());
    c.state.mesh.patches.clear();
    c.problem.conditions.kind.clear();
    c.state.mesh.solid = {};
    c.state.mesh.fluid = {{{0, 1, 2}}, {0}};
    EXPECT_NEAR(check(c).fluid.worst, 1, 1e-12);
    c.state.mesh.fluid.nodes = {{0, 1, 3}};  // right-angled: 2 (sqrt 2 - 1)
    EXPECT_NEAR(check(c).fluid.worst, 2 * (std::sqrt(2.0) - 1), 1e-12);
    EXPECT_EQ(check(c).fluid.histogram[8], 1);
}

TEST(CheckMesh, FaultsAreFound) {
    TestCase inverted = pair();
    std::swap(inverted.state.mesh.solid.nodes[3][0], inverted.state.mesh.solid.nodes[3][1]);
    EXPECT_EQ(check(inverted).solid.inverted, 1);
    EXPECT_EQ(check(inverted).faults.size(), 1u);

    TestCase crowded = pair();
    crowded.state.mesh.solid.nodes.push_back(crowded.state.mesh.solid.nodes[0]);
    crowded.state.mesh.solid.nodes.push_back(crowded.state.mesh.solid.nodes[0]);
    EXPECT_EQ(check(crowded).faults.size(), 3u) << "its three edges";

    // the block's nodes on the interface doubled: 6 twins, 5 faces of false free surface
    TestCase twins = pair();
    auto& nodes = twins.state.nodes;
    std::vector<int> twin(nodes.x.size(), -1);
    const auto topology = twins.topology();
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.interface(i)) {
            twin[i] = nodes.size();
            nodes.append(Nodes<2>(nodes), i);
            nodes.id.back() = twins.state.nextId++;
            nodes.wall[i] = topology.supports[i];  // the fluid's
        }
    for (auto& cell : twins.state.mesh.solid.nodes)
        for (int& i : cell)
            if (twin[i] >= 0) i = twin[i];
    const MeshCheck<2> result = check(twins);
    EXPECT_EQ(result.faults.size(), 6u);
    EXPECT_EQ(result.gaps.size(), 5u);
    EXPECT_NEAR(result.interface, 0, 1e-12);
}

}  // namespace pfem
