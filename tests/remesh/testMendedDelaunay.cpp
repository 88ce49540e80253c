// The triangulation of points that have moved: the same as from nothing.

#include "remesh/mendedDelaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <random>

#include "remesh/spaceDelaunay.hpp"
#include "support/cases3.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

std::vector<int> upTo(int n) {
    std::vector<int> list(n);
    std::iota(list.begin(), list.end(), 0);
    return list;
}

/// A box of n points, a sheet over it and some drops; a quarter of each axis of it is a lattice where wanted, whose
/// cubes have eight nodes on one sphere and whose sides have many in one plane.
Points<3> someWater(std::mt19937& random, int n, bool lattice) {
    std::uniform_real_distribution<double> unit(0, 1);
    Points<3> x;
    for (int i = 0; i < n; ++i) x.emplace_back(unit(random), 0.5 * unit(random), 0.5 * unit(random));
    for (int i = 0; i < n / 8; ++i) x.emplace_back(1.5 * unit(random), 0.5 * unit(random), 0.6 + 1e-3 * unit(random));
    for (int i = 0; i < 10; ++i) x.emplace_back(3 * unit(random), 3 * unit(random), 3 * unit(random));
    for (int i = 0; lattice && i < 6 * 6 * 6; ++i) {
        const int row = i / 6 % 6, layer = i / 36;
        x.emplace_back(1.2 + 0.05 * (i % 6), 0.05 * row, 0.05 * layer);
    }
    return x;
}

void expectThatFromNothing(const std::optional<Triangulation<3>>& mended, const Triangulation<3>& whole,
                           const std::string& what) {
    ASSERT_TRUE(mended.has_value()) << what;
    EXPECT_EQ(mended->cells, whole.cells) << what;
    EXPECT_EQ(mended->neighbours, whole.neighbours) << what;
}

/// The part of the cells of `last` that are cells of `whole`, too.
double partOfLast(const Triangulation<3>& last, const Triangulation<3>& whole) {
    std::vector<Simplex<3>> both;
    std::set_intersection(last.cells.begin(), last.cells.end(), whole.cells.begin(), whole.cells.end(),
                          std::back_inserter(both));
    return static_cast<double>(both.size()) / static_cast<double>(last.cells.size());
}

}  // namespace

/// Points that move by up to a tenth of their distance; some at rest, some on a floor.
TEST(MendedDelaunay, equalsThatFromNothing) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    int nMended = 0;
    for (int n = 1; n <= 40; ++n) {
        Points<3> x = someWater(random, 30 * n, n % 3 == 0);
        for (auto& point : x)
            if (n % 2 == 0 && point[2] < 0.1) point[2] = 0;
        const auto active = upTo(static_cast<int>(x.size()));
        Triangulation<3> last = spaceDelaunay(x, active);
        const double h = std::cbrt(0.25 / (30 * n));
        for (int step = 0; step < 3; ++step) {
            for (auto& point : x) {
                if (n % 4 == 1 && point[0] < 0.7) continue;
                for (int d = 0; d < (point[2] == 0 ? 2 : 3); ++d) point[d] += 0.1 / (1 + n % 5) * h * unit(random);
            }
            const auto mended = mendedDelaunay(x, active, last, active, 2.6 * h);
            const std::string what = "water " + std::to_string(n) + " step " + std::to_string(step);
            const Triangulation<3> whole = spaceDelaunay(x, active);
            if (mended || partOfLast(last, whole) > 0.6) expectThatFromNothing(mended, whole, what);
            if (HasFailure()) return;
            nMended += mended.has_value();
            last = whole;
        }
    }
    EXPECT_GT(nMended, 80);
}

/// Nodes go and come: numbers change, their order stays.
TEST(MendedDelaunay, pointsThatGoAndCome) {
    std::mt19937 random(12);
    Points<3> x = someWater(random, 1500, false);
    const int nOld = static_cast<int>(x.size());
    const Triangulation<3> last = spaceDelaunay(x, upTo(nOld));
    std::vector<int> now(nOld, -1);
    Points<3> next;
    for (int i = 0; i < nOld; ++i) {
        if (i % 97 == 0) continue;
        now[i] = static_cast<int>(next.size());
        next.push_back(x[i]);
    }
    for (int i = 0; i < 20; ++i) next.push_back(0.5 * (x[7 * i] + x[7 * i + 3]));
    std::vector<int> active = upTo(static_cast<int>(next.size()));
    expectThatFromNothing(mendedDelaunay(next, active, last, now, 0.3), spaceDelaunay(next, active),
                          "points that go and come");

    std::erase_if(active, [](int i) { return i % 50 == 3; });  // they take no part
    for (int& i : now)
        if (i % 50 == 3) i = -1;
    expectThatFromNothing(mendedDelaunay(next, active, last, now, 0.3), spaceDelaunay(next, active),
                          "points that take no part");
}

TEST(MendedDelaunay, nothingIsProvenWhereAllHasChanged) {
    std::mt19937 random(13);
    Points<3> x = someWater(random, 500, false);
    const auto active = upTo(static_cast<int>(x.size()));
    const Triangulation<3> last = spaceDelaunay(x, active);
    Points<3> twins = x;
    twins[5] = twins[200];
    EXPECT_FALSE(mendedDelaunay(twins, active, last, active, 0.3).has_value());
    std::shuffle(x.begin(), x.end(), random);
    EXPECT_FALSE(mendedDelaunay(x, active, last, active, 0.3).has_value());
}

/// The triangulator of a run in the steps of a dam break.
TEST(MendedDelaunay, followsADamBreak) {
    TestCase3 c = boxOfWater({0.4, 0.3, 0.4}, {1.2, 0.3, 0.8}, 0.08, "slip", 1e-3, 0.2);
    c.start(2e-3);
    Triangulator<3> triangulator(Ranks(), 2.6 * 0.08);
    for (int n = 0; n < 100; ++n) {
        c.step(6e-3);
        const auto& nodes = c.state.nodes;
        std::vector<unsigned char> isOfWall(nodes.size(), 0);
        for (const auto& patch : c.state.mesh.patches)
            for (const auto& face : patch.faces)
                for (const int node : face) isOfWall[node] = 1;
        std::vector<int> active;
        for (int i = 0; i < nodes.size(); ++i)
            if (!isOfWall[i]) active.push_back(i);
        triangulator.follow(nodes.x, nodes.id, active, {}, {});
        expectThatFromNothing(triangulator.triangulation(nodes.size()), spaceDelaunay(nodes.x, active),
                              "state " + std::to_string(n));
        if (HasFailure()) return;
    }
}
