// The triangulation that ranks share: the ranks one after the other in this process.

#include "remesh/sharedDelaunay.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "remesh/provenCells.hpp"
#include "remesh/spaceDelaunay.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

std::vector<int> all(const Points<3>& x) {
    std::vector<int> list(x.size());
    std::iota(list.begin(), list.end(), 0);
    return list;
}

/// What sharedDelaunay sends and receives; `proven`: how many cells the ranks have known.
std::optional<Triangulation<3>> byRanks(const Points<3>& x, const std::vector<int>& active, int nRanks, double halo,
                                        std::size_t& proven) {
    const auto parts = bisect<3>(x, active, nRanks);
    UnsetVector<Simplex<3>> known;
    for (int rank = 0; rank < nRanks; ++rank) {
        const auto mine = provenCells(x, active, parts, rank, halo).cells;
        known.insert(known.end(), mine.begin(), mine.end());
    }
    proven = known.size();
    std::sort(known.begin(), known.end());
    UnsetVector<std::array<int, 4>> unknown(known.size(), {-1, -1, -1, -1});
    return completed(x, active, {std::move(known), std::move(unknown)});
}

/// The same cells with the same neighbours. Returns the part of the cells that ranks have proven.
double expectSame(const Points<3>& x, const std::vector<int>& active, int nRanks, double halo,
                  const std::string& what) {
    const Triangulation<3> whole = spaceDelaunay(x, active);
    std::size_t proven = 0;
    const auto shared = byRanks(x, active, nRanks, halo, proven);
    EXPECT_TRUE(shared.has_value()) << what;
    if (!shared) return 0;
    EXPECT_EQ(shared->cells, whole.cells) << what;
    EXPECT_EQ(shared->neighbours, whole.neighbours) << what;
    const auto threaded = threadedDelaunay(x, active, nRanks, halo);
    EXPECT_TRUE(threaded.has_value()) << what;
    if (!threaded) return 0;
    EXPECT_EQ(threaded->cells, whole.cells) << what;
    EXPECT_EQ(threaded->neighbours, whole.neighbours) << what;
    return static_cast<double>(proven) / static_cast<double>(std::max<std::size_t>(whole.cells.size(), 1));
}

/// A cloud, a sheet over it, some drops; in some of them parts of a lattice, whose cubes have eight nodes on one
/// sphere and whose sides have many in one plane.
Points<3> someSplash(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto size = [&](int most) { return static_cast<int>(most * unit(random)); };
    Points<3> x;
    for (int n = 20 + size(1500); n > 0; --n) x.emplace_back(unit(random), 0.6 * unit(random), 0.4 * unit(random));
    for (int n = size(300); n > 0; --n) x.emplace_back(2 * unit(random), unit(random), 0.7 + 1e-3 * unit(random));
    for (int n = size(20); n > 0; --n) x.emplace_back(3 * unit(random), 3 * unit(random), 3 * unit(random));
    if (seed % 3 == 0)
        for (int i = 0; i < 7 * 6 * 5; ++i) {
            const int row = i / 7 % 6, layer = i / 42;
            x.emplace_back(1.25 + 0.25 * (i % 7), 0.25 * row, 0.25 * layer);
        }
    if (seed % 5 == 0)
        for (int n = size(200); n > 0; --n) x.emplace_back(unit(random), 0.6 * unit(random), 0.0);
    return x;
}

/// All but the points of walls, which take no part.
std::vector<int> movingNodes(const State<3>& state) {
    std::vector<unsigned char> isOfWall(state.nodes.size(), 0);
    for (const auto& patch : state.mesh.patches)
        for (const auto& face : patch.faces)
            for (const int node : face) isOfWall[node] = 1;
    std::vector<int> nodes;
    for (int i = 0; i < state.nodes.size(); ++i)
        if (!isOfWall[i]) nodes.push_back(i);
    return nodes;
}

}  // namespace

TEST(SharedDelaunay, equalsThatOfOneRank) {
    constexpr int ranks[] = {2, 3, 4, 7};
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const Points<3> x = someSplash(seed);
        expectSame(x, all(x), ranks[seed % 4], 0.1 * (seed / 4 % 4), "splash " + std::to_string(seed));
    }
}

/// 100 states of a dam break; with a halo of twice the largest circumradius of fluid the ranks prove nearly all.
TEST(SharedDelaunay, equalsThatOfOneRankInADamBreak) {
    TestCase3 c = boxOfWater({0.4, 0.3, 0.4}, {1.2, 0.3, 0.8}, 0.08, "slip", 1e-3, 0.2);
    c.start(2e-3);
    double least = 1;
    for (int n = 0; n < 100; ++n) {
        c.step(6e-3);
        const int nRanks = 2 + n % 3;
        least = std::min(
            least, expectSame(c.state.nodes.x, movingNodes(c.state), nRanks, 2.6 * 0.08, "state " + std::to_string(n)));
    }
    EXPECT_GT(least, 0.7);
}

TEST(SharedDelaunay, smallOnesAndFlatOnes) {
    expectSame({}, {}, 3, 1, "nothing");
    const Points<3> few{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}};
    for (int n = 1; n <= 5; ++n) expectSame(few, all(Points<3>(few.begin(), few.begin() + n)), 4, 0.5, "few");
    const Points<3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.4, 0.3, 0}};
    expectSame(flat, all(flat), 2, 0.5, "flat");
    Points<3> x = someSplash(4);
    std::vector<int> odd;
    for (std::size_t i = 1; i < x.size(); i += 2) odd.push_back(static_cast<int>(i));
    expectSame(x, odd, 3, 0.1, "every other point");
}

/// Which of two points at one place stands for both, one rank alone cannot tell.
TEST(SharedDelaunay, pointsAtOnePlaceAreSeen) {
    Points<3> x = someSplash(7);
    EXPECT_FALSE(provenCells(x, all(x), bisect<3>(x, all(x), 2), 0, 0.1).coincide);
    x.push_back(x[5]);
    const auto parts = bisect<3>(x, all(x), 2);
    EXPECT_TRUE(provenCells(x, all(x), parts, parts.owner[5], 0.1).coincide);
    bool coincide = false;
    const auto whole = spaceDelaunay(x, all(x), &coincide);
    EXPECT_TRUE(coincide);
    EXPECT_EQ(sharedDelaunay(x, all(x), Ranks(), 0.1).cells, whole.cells);
    EXPECT_FALSE(threadedDelaunay(x, all(x), 2, 0.1).has_value());
}

/// The sphere of a regular tetrahedron of edge 2 sqrt 2 about the origin has the radius sqrt 3.
TEST(SharedDelaunay, spheresWithinARegion) {
    const Points<3> x{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const auto within = [&](double side) {
        return sphereIsWithin(x, {0, 2, 1, 3}, {Vec<3>::Constant(-2), Vec<3>(side, 2, 2)});
    };
    EXPECT_TRUE(within(std::sqrt(3) + 1e-9));
    EXPECT_FALSE(within(std::sqrt(3) - 1e-9));
    EXPECT_FALSE(within(std::sqrt(3)));
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(sphereIsWithin(x, {0, 2, 1, 3}, {Vec<3>::Constant(-infinity), Vec<3>::Constant(infinity)}));
    const Points<3> flat{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 1e-16}};
    EXPECT_FALSE(sphereIsWithin(flat, {0, 1, 2, 3}, {Vec<3>::Constant(-2), Vec<3>::Constant(2)}));
}

TEST(Bisection, partsOfEqualNumbersInTheirRegions) {
    const Points<3> x = someSplash(9);
    for (const int nParts : {1, 2, 3, 5, 8}) {
        const auto parts = bisect<3>(x, all(x), nParts);
        ASSERT_EQ(parts.regions.size(), static_cast<std::size_t>(nParts));
        std::vector<int> count(nParts, 0);
        for (std::size_t i = 0; i < x.size(); ++i) {
            ++count[parts.owner[i]];
            EXPECT_TRUE(parts.regions[parts.owner[i]].contains(x[i]));
        }
        const auto [least, most] = std::minmax_element(count.begin(), count.end());
        EXPECT_LE(*most - *least, 3) << nParts;
    }
}
