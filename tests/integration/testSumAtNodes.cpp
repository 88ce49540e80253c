// Sums of the nodes over their cells, by threads and shares.

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "integration/sumAtNodes.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A cube of tetrahedra, in any order.
State<3> shuffledLattice() {
    State<3> state;
    addLattice(state, state.mesh.fluid, 0, {0, 0, 0}, {8, 8, 8}, 1);
    std::shuffle(state.mesh.fluid.nodes.begin(), state.mesh.fluid.nodes.end(), std::mt19937(1));
    return state;
}

/// What corner k of cell e gives: numbers whose sum depends on their order.
double given(int e, int k) { return std::sin(1.0 + e * 4 + k) * std::pow(10, e % 7); }

/// Nodes' sums, 1 from the start.
std::vector<double> sums(const SmoothingDomains<3>& domains) {
    std::vector<double> sum(domains.nNodes(), 1);
    sumAtNodes(domains, [&](int e) { return [&sum, e](int k, int node) { sum[node] += given(e, k); }; });
    return sum;
}

std::vector<double> gathered(const NodeToCells& around) {
    const int nNodes = static_cast<int>(around.start.size()) - 1;
    std::vector<double> sum(nNodes, 1);
    for (int i = 0; i < nNodes; ++i)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) sum[i] += given(around.cell[s], around.corner[s]);
    return sum;
}

}  // namespace

TEST(SumAtNodes, hasTheBitsOfGatheringForAnyNumberOfThreads) {
    const auto state = shuffledLattice();
    const auto& cells = state.mesh.fluid.nodes;
    const int nNodes = state.nodes.size();
    ASSERT_GT(cells.size(), shortLoop);
    const auto around = nodeToCells<3>(cells, nNodes);
    const auto domains = makeSmoothingDomains<3>(cells, around, state.nodes.x);
    const int threads = omp_get_max_threads();
    for (const int n : {1, 2, 3, 8}) {
        omp_set_num_threads(n);
        EXPECT_EQ(sums(domains), gathered(around)) << n << " threads";
    }
    omp_set_num_threads(threads);
}

/// A rank's nodes have all of theirs; the others keep what they had.
TEST(SumAtNodes, ofAShareAreThoseOfItsNodes) {
    const auto state = shuffledLattice();
    const auto& cells = state.mesh.fluid.nodes;
    const int nNodes = state.nodes.size();
    const auto around = nodeToCells<3>(cells, nNodes);
    std::vector<int> nodes, ofNodes;
    std::vector<unsigned char> marks(nNodes, 0);
    for (int i = nNodes / 3; i < nNodes / 2; ++i) {
        nodes.push_back(i);
        marks[i] = 1;
    }
    for (int e = 0; e < static_cast<int>(cells.size()); ++e)
        if (std::any_of(cells[e].begin(), cells[e].end(), [&](int node) { return marks[node]; })) ofNodes.push_back(e);
    const Share share(Ranks(), {nNodes}, nodes, ofNodes);
    const auto domains = makeSmoothingDomains<3>(cells, around, state.nodes.x, Integration::nodal, share);
    const auto found = sums(domains), all = gathered(around);
    for (int i = 0; i < nNodes; ++i) EXPECT_EQ(found[i], marks[i] ? all[i] : 1) << i;
}
