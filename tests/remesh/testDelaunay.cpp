// The constrained Delaunay triangulation.

#include "remesh/delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "support/cases.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

Points<2> randomPoints(int n, unsigned seed) {
    Points<2> x = randomVectors(n, seed);
    return x;
}

std::vector<int> all(const Points<2>& x) {
    std::vector<int> list(x.size());
    std::iota(list.begin(), list.end(), 0);
    return list;
}

std::set<std::set<int>> edgesOf(const Triangulation<2>& t) {
    std::set<std::set<int>> edges;
    for (const auto& s : t.cells)
        for (int k = 0; k < 3; ++k) edges.insert({s[k], s[(k + 1) % 3]});
    return edges;
}

double area(const Points<2>& x, const Triangulation<2>& t) {
    double sum = 0;
    for (const auto& s : t.cells) sum += simplexMeasure<2>(x, s);
    return sum;
}

/// > 0 when p lies inside the circle through the cell's nodes.
double inCircle(const Points<2>& x, const Simplex<2>& s, const Vec<2>& p) {
    Eigen::Matrix3d m;
    for (int k = 0; k < 3; ++k) {
        const Vec<2> d = x[s[k]] - p;
        m.row(k) << d[0], d[1], d.squaredNorm();
    }
    return m.determinant();
}

TEST(Delaunay, circumcirclesAreEmpty) {
    const auto x = randomPoints(150, 2);
    const auto t = constrainedDelaunay(x, all(x), {}, {});
    for (const auto& s : t.cells) {
        EXPECT_GT(simplexMeasure<2>(x, s), 0);
        for (int i = 0; i < 150; ++i)
            if (std::find(s.begin(), s.end(), i) == s.end()) {
                EXPECT_LT(inCircle(x, s, x[i]), 1e-12);
            }
    }
}

TEST(Delaunay, neighboursShareTheFaceOppositeToTheirNode) {
    const auto x = randomPoints(80, 4);
    const auto t = constrainedDelaunay(x, all(x), {}, {});
    int hull = 0;
    for (std::size_t e = 0; e < t.cells.size(); ++e)
        for (int k = 0; k < 3; ++k) {
            const int other = t.neighbours[e][k];
            if (other < 0) {
                ++hull;
                continue;
            }
            for (int l = 1; l <= 2; ++l) {
                const auto& cell = t.cells[other];
                EXPECT_NE(std::find(cell.begin(), cell.end(), t.cells[e][(k + l) % 3]), cell.end());
            }
        }
    EXPECT_GE(hull, 3);
}

TEST(Delaunay, onlyActivePointsOnce) {
    auto x = randomPoints(20, 4);
    x.push_back(x[3]);  // coincides with an earlier one
    std::vector<int> active;
    for (int i = 0; i < 21; ++i)
        if (i != 7) active.push_back(i);
    const auto t = constrainedDelaunay(x, active, {}, {});
    std::set<int> used;
    for (const auto& s : t.cells) used.insert(s.begin(), s.end());
    EXPECT_EQ(used.count(7), 0u);
    EXPECT_EQ(used.count(3) + used.count(20), 1u);
    EXPECT_EQ(used.size(), 19u);
}

TEST(Delaunay, fixedFacesAppear) {
    auto x = randomPoints(120, 6);
    x.push_back({-2, 0.01});
    x.push_back({2, -0.02});  // a wall right across
    const auto t = constrainedDelaunay(x, all(x), {{120, 121}}, {});
    EXPECT_EQ(edgesOf(t).count({120, 121}), 1u);
    const Vec<2> a = x[120], n(-(x[121] - a)[1], (x[121] - a)[0]);
    for (const auto& s : t.cells) {  // no triangle on both sides
        double least = 0, most = 0;
        for (int node : s) {
            least = std::min(least, n.dot(x[node] - a));
            most = std::max(most, n.dot(x[node] - a));
        }
        EXPECT_FALSE(least < -1e-12 && most > 1e-12);
    }
}

TEST(Delaunay, fixedFacesOfCoincidentPointsAppear) {
    // a node that slid into the corner of a wall: whichever of the two is left out, the wall stays closed
    auto x = randomPoints(120, 6);
    x.push_back({-2, 0.01});
    x.push_back({2, -0.02});
    x.push_back(x[120]);
    x.push_back(x[121]);
    for (const Face<2>& wall : {Face<2>{120, 121}, Face<2>{122, 123}, Face<2>{120, 123}}) {
        const auto edges = edgesOf(constrainedDelaunay(x, all(x), {wall, {120, 122}}, {}));
        int found = 0;
        for (int a : {120, 122})
            for (int b : {121, 123}) found += static_cast<int>(edges.count({a, b}));
        EXPECT_EQ(found, 1);
    }
}

TEST(Delaunay, repeatedAndCollinearFacesAreFine) {
    // the side of a solid that is also a symmetry patch: every face twice, in both directions
    Points<2> x;
    for (int i = 0; i <= 10; ++i) x.push_back({0, 0.1 * i});
    for (int i = 0; i <= 10; ++i) x.push_back({0.1, 0.1 * i});
    std::vector<Face<2>> fixed;
    for (int i = 0; i < 10; ++i) {
        fixed.push_back({i, i + 1});
        fixed.push_back({i + 1, i});
        fixed.push_back({i, i + 1});
    }
    Triangulation<2> t;
    ASSERT_NO_THROW(t = constrainedDelaunay(x, all(x), fixed, fixed));
    EXPECT_NEAR(area(x, t), 0.1, 1e-14);
}

TEST(Delaunay, wishedFacesYield) {
    const Points<2> x = {{-1, 0}, {1, 0}, {0, -3}, {0, 3}, {-0.5, 1}, {0.5, 1.1}};
    const auto crossing = edgesOf(constrainedDelaunay(x, all(x), {{0, 1}}, {{2, 3}, {4, 5}}));
    EXPECT_EQ(crossing.count({0, 1}), 1u);
    EXPECT_EQ(crossing.count({2, 3}), 0u);  // would cross
    EXPECT_EQ(crossing.count({4, 5}), 1u);
    // a wished face that coincides with a fixed one, or comes twice, does not spoil the others
    const auto twice = edgesOf(constrainedDelaunay(x, all(x), {{0, 1}}, {{1, 0}, {2, 3}, {4, 5}, {5, 4}, {0, 3}}));
    EXPECT_EQ(twice.count({4, 5}), 1u);
    EXPECT_EQ(twice.count({0, 3}), 1u);
}

TEST(Delaunay, wishedFacesAppearAgainstDelaunay) {
    const Points<2> x = {{0, 0}, {4, 0}, {2, 0.5}, {2, -0.5}};  // Delaunay takes the short diagonal
    EXPECT_EQ(edgesOf(constrainedDelaunay(x, all(x), {}, {})).count({0, 1}), 0u);
    EXPECT_EQ(edgesOf(constrainedDelaunay(x, all(x), {}, {{0, 1}})).count({0, 1}), 1u);
}

TEST(Delaunay, crossingFixedFacesFailTheStep) {
    const Points<2> x = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    EXPECT_THROW(constrainedDelaunay(x, all(x), {{0, 1}, {2, 3}}, {}), StepFailure);
}

/// Points that move, come and go, with some edges that are asked for.
struct Swarm {
    std::mt19937 random;
    Points<2> x;
    std::vector<Id> ids;
    Id nextId = 0;

    double draw(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    void add(const Vec<2>& point) {
        x.push_back(point);
        ids.push_back(nextId++);
    }
    void removeAt(std::size_t k) {
        x.erase(x.begin() + static_cast<std::ptrdiff_t>(k));
        ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(k));
    }
    std::vector<Face<2>> wished() {
        std::vector<Face<2>> faces;
        for (int k = 0; k < 40; ++k) {
            const int a = static_cast<int>(draw(0, static_cast<double>(x.size()))),
                      b = static_cast<int>(draw(0, static_cast<double>(x.size())));
            if (a != b && (x[a] - x[b]).norm() < 0.2) faces.push_back({a, b});
        }
        return faces;
    }
    /// Returns how many points have changed since the last triangulation of which `triangulator` knows.
    void expectSame(Triangulator<2>& triangulator, const std::vector<Face<2>>& fixed, const std::string& what) {
        const auto faces = wished();
        triangulator.follow(x, ids, all(x), fixed, faces);
        const auto mended = triangulator.triangulation(static_cast<int>(x.size()));
        const auto anew = constrainedDelaunay(x, all(x), fixed, faces);
        EXPECT_EQ(mended.cells, anew.cells) << what;
        EXPECT_EQ(mended.neighbours, anew.neighbours) << what;
    }
};

TEST(Triangulator, mendsToWhatComesFromNothing) {
    for (const double step : {1e-4, 0.01, 0.05, 0.3}) {  // 0.05: the distance of neighbours
        Swarm swarm{std::mt19937(7), {}, {}};
        for (const auto& corner : {Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(1, 1), Vec<2>(0, 1)}) swarm.add(corner);
        for (int i = 0; i < 400; ++i) swarm.add({swarm.draw(0, 1), swarm.draw(0, 1)});
        Triangulator<2> triangulator;
        for (int round = 0; round < 30; ++round) {
            swarm.expectSame(triangulator, {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                             std::to_string(step) + " round " + std::to_string(round));
            for (std::size_t i = 4; i < swarm.x.size(); ++i)
                for (int d = 0; d < 2; ++d)
                    swarm.x[i][d] = std::clamp(swarm.x[i][d] + step * swarm.draw(-1, 1), 0.0, 1.0);
            for (int k = 0; k < round % 4; ++k) {
                swarm.removeAt(static_cast<std::size_t>(swarm.draw(4, static_cast<double>(swarm.x.size()))));
                swarm.add({swarm.draw(0, 1), swarm.draw(0, 1)});
            }
        }
    }
}

// No box: the hull itself moves, with dents and points that leave it; and squares, whose corners are on one circle.
TEST(Triangulator, hullsAndCircles) {
    Swarm swarm{std::mt19937(3), {}, {}};
    for (int i = 0; i < 15; ++i)
        for (int j = 0; j < 15; ++j) swarm.add({0.1 * i, 0.1 * j});
    Triangulator<2> triangulator;
    for (int round = 0; round < 40; ++round) {
        swarm.expectSame(triangulator, {}, "round " + std::to_string(round));
        if (round % 3 == 0)  // a shear keeps points on lines and takes them off circles
            for (auto& point : swarm.x) point[0] += 0.02 * point[1];
        else if (round % 3 == 1)  // and back
            for (auto& point : swarm.x) point[0] -= 0.02 * point[1];
        else if (round > 20)
            for (auto& point : swarm.x) point += 0.03 * Vec<2>(swarm.draw(-1, 1), swarm.draw(-1, 1));
    }
}

// Points that fall on one another and part again; all on one line; fixed faces that cross.
TEST(Triangulator, goesOnAfterWhatCannotBe) {
    Swarm swarm{std::mt19937(5), {}, {}};
    for (int i = 0; i < 100; ++i) swarm.add({swarm.draw(0, 1), swarm.draw(0, 1)});
    Triangulator<2> triangulator;
    swarm.expectSame(triangulator, {}, "start");
    const Vec<2> before = swarm.x[17];
    swarm.x[17] = swarm.x[40];
    swarm.expectSame(triangulator, {}, "twins");
    swarm.x[17] = before;
    swarm.expectSame(triangulator, {}, "parted");
    const Points<2> x = swarm.x;
    for (auto& point : swarm.x) point[1] = 0.5;
    swarm.expectSame(triangulator, {}, "line");
    swarm.x = x;
    swarm.expectSame(triangulator, {}, "plane");
    swarm.x[0] = {-1, -1}, swarm.x[1] = {2, 2}, swarm.x[2] = {-1, 2}, swarm.x[3] = {2, -1};
    EXPECT_THROW(triangulator.follow(swarm.x, swarm.ids, all(swarm.x), {{0, 1}, {2, 3}}, {}), StepFailure);
    swarm.expectSame(triangulator, {{0, 1}}, "after crossing walls");
    swarm.x.resize(3), swarm.ids.resize(3);
    swarm.expectSame(triangulator, {}, "nearly all gone");
}

}  // namespace
