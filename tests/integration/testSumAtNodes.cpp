// Sums of the nodes over their cells, by threads and shares.

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "integration/sumAtNodes.hpp"

using namespace pfem;

namespace {

constexpr int m = 9, nNodes = m * m * m;

/// A lattice of cubes of six tetrahedra each, in any order.
std::vector<Simplex<3>> shuffledLattice() {
    std::vector<Simplex<3>> cells;
    for (int corner = 0; corner < nNodes; ++corner) {
        if (corner % m == m - 1 || corner / m % m == m - 1 || corner / (m * m) == m - 1) continue;
        std::array<int, 3> step{1, m, m * m};
        do {
            const int b = corner + step[0], c = b + step[1];
            cells.push_back({corner, b, c, c + step[2]});
        } while (std::next_permutation(step.begin(), step.end()));
    }
    std::shuffle(cells.begin(), cells.end(), std::mt19937(1));
    return cells;
}

Points<3> places() {
    Points<3> x;
    for (int i = 0; i < nNodes; ++i) x.emplace_back(i % m, i / m % m, i / (m * m));
    return x;
}

/// What corner k of cell e gives: numbers whose sum depends on their order.
double given(int e, int k) { return std::sin(1.0 + e * 4 + k) * std::pow(10, e % 7); }

/// Nodes' sums, 1 from the start.
std::vector<double> sums(const SmoothingDomains<3>& domains) {
    std::vector<double> sum(nNodes, 1);
    sumAtNodes(domains, [&](int e) { return [&sum, e](int k, int node) { sum[node] += given(e, k); }; });
    return sum;
}

std::vector<double> gathered(const NodeToCells& around) {
    std::vector<double> sum(nNodes, 1);
    for (int i = 0; i < nNodes; ++i)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) sum[i] += given(around.cell[s], around.corner[s]);
    return sum;
}

}  // namespace

TEST(SumAtNodes, hasTheBitsOfGatheringForAnyNumberOfThreads) {
    const auto cells = shuffledLattice();
    ASSERT_GT(cells.size(), shortLoop);
    const auto around = nodeToCells<3>(cells, nNodes);
    const auto domains = makeSmoothingDomains<3>(cells, around, places());
    const int threads = omp_get_max_threads();
    for (const int n : {1, 2, 3, 8}) {
        omp_set_num_threads(n);
        EXPECT_EQ(sums(domains), gathered(around)) << n << " threads";
    }
    omp_set_num_threads(threads);
}

/// A rank's nodes have all of theirs; the others keep what they had.
TEST(SumAtNodes, ofAShareAreThoseOfItsNodes) {
    const auto cells = shuffledLattice();
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
    const auto domains = makeSmoothingDomains<3>(cells, around, places(), Integration::nodal, share);
    const auto found = sums(domains), all = gathered(around);
    for (int i = 0; i < nNodes; ++i) EXPECT_EQ(found[i], marks[i] ? all[i] : 1) << i;
}
