// Samples of triangles, lines and balls; what a plane leaves of polygons and tetrahedra; the edges of a surface.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "picture/cut.hpp"
#include "picture/layer.hpp"
#include "picture/skin.hpp"

using namespace pfem;

namespace {

constexpr Colour red{255, 0, 0}, blue{0, 0, 255};
constexpr Rows rows{100, 0, 100};

RasterPoint at(double x, double y, double depth = 1, double value = 0, double scale = 1) {
    return {{x, y}, depth, scale, value, Vec<3>::UnitZ()};
}

void put(Layer& layer, const std::array<RasterPoint, 3>& triangle, Colour colour) {
    forTriangle(triangle, rows, [&](int x, int y, const Fragment& f) { layer.put(x, y, f.depth, colour); });
}

TEST(Raster, theNearTriangleHidesTheFarOneInBothOrders) {
    const std::array<RasterPoint, 3> near{at(0, 0, 1), at(60, 0, 1), at(0, 60, 1)};
    const std::array<RasterPoint, 3> far{at(0, 0, 2), at(90, 0, 2), at(0, 90, 2)};
    for (const bool nearFirst : {true, false}) {
        Layer layer(rows);
        put(layer, nearFirst ? near : far, nearFirst ? red : blue);
        put(layer, nearFirst ? far : near, nearFirst ? blue : red);
        EXPECT_EQ(layer.colour(10, 10), red);
        EXPECT_EQ(layer.colour(40, 40), blue);
        EXPECT_EQ(layer.colour(80, 80), white);
    }
}

TEST(Raster, trianglesThatCrossChangeWhereTheirDepthsAreEqual) {
    Layer layer(rows);
    put(layer, {at(0, 0, 1), at(100, 0, 3), at(0, 100, 1)}, red);  // depth 1 + 2 x/100
    put(layer, {at(0, 0, 2), at(100, 0, 2), at(0, 100, 2)}, blue);
    EXPECT_EQ(layer.colour(48, 10), red);
    EXPECT_EQ(layer.colour(51, 10), blue);
}

TEST(Raster, eachSampleOfAFanBelongsToOneTriangle) {
    std::vector<int> count(100 * 100, 0);
    const Vec<2> middle(50.5, 50.5);  // edges through samples
    const std::vector<Vec<2>> rim{{10.5, 10.5}, {50.5, 10.5}, {90.5, 10.5}, {90.5, 90.5}, {10.5, 90.5}, {10.5, 50.5}};
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const Vec<2>&a = rim[k], &b = rim[(k + 1) % rim.size()];
        std::array<RasterPoint, 3> t{at(a[0], a[1]), at(b[0], b[1]), at(middle[0], middle[1])};
        if (k % 2) std::swap(t[0], t[1]);
        forTriangle(t, rows, [&](int x, int y, const Fragment&) { ++count[100 * y + x]; });
    }
    int sum = 0;
    for (const int n : count) {
        EXPECT_LE(n, 1);
        sum += n;
    }
    EXPECT_EQ(sum, 80 * 80);
}

// A value linear in space: at half the way in the picture from depth 1 to depth 3 it is at 1/4 of its way.
TEST(Raster, valuesAreLinearInSpace) {
    double seen = -1, depth = -1;
    forTriangle({at(0, 0, 1, 0, 1), at(100, 0, 3, 1, 1.0 / 3), at(0, 100, 1, 0, 1)}, rows,
                [&](int x, int y, const Fragment& f) {
                    if (x == 49 && y == 0) std::tie(seen, depth) = std::tie(f.value, f.depth);
                });
    EXPECT_NEAR(seen, 0.25, 0.005);
    EXPECT_NEAR(depth, 1.5, 0.01);
}

TEST(Raster, linesAndBallsHaveTheirArea) {
    int line = 0, ball = 0;
    forLine(at(10, 20), at(80, 60), 6, rows, [&](int, int, double) { ++line; });
    EXPECT_NEAR(line, std::hypot(70, 40) * 6 + 3.14159 * 9, 8);
    forBall(at(50, 50, 10), 30, 3, rows, [&](int x, int y, const Fragment& f) {
        ++ball;
        if (x == 50 && y == 50) {
            EXPECT_NEAR(f.depth, 7, 0.01);
        }
        if (y < 45) {
            EXPECT_GT(f.normal[1], 0);
        }  // upwards
    });
    EXPECT_NEAR(ball, 3.14159 * 900, 15);
}

double area(const Corners3& polygon) {
    Vec<3> sum = Vec<3>::Zero();
    for (std::size_t k = 2; k < polygon.size(); ++k)
        sum += 0.5 * (polygon[k - 1].x - polygon[0].x).cross(polygon[k].x - polygon[0].x);
    return sum.norm();
}

TEST(Cut, sectionsOfTheUnitTetrahedron) {
    const std::array<Corner3, 4> corners{Corner3{Vec<3>::Zero()}, Corner3{Vec<3>::UnitX(), Vec<3>::Zero(), 8},
                                         Corner3{Vec<3>::UnitY()}, Corner3{Vec<3>::UnitZ()}};
    const Corners3 triangle = section({{0.25, 0, 0}, Vec<3>::UnitX()}, corners);
    EXPECT_NEAR(area(triangle), 0.5 * 0.75 * 0.75, 1e-14);
    for (const Corner3& corner : triangle) EXPECT_NEAR(corner.value, 2, 1e-14);
    const Vec<3> skew = Vec<3>(1, 1, 0).normalized();
    EXPECT_NEAR(area(section({{0.25, 0.25, 0}, skew}, corners)), std::sqrt(0.5) * 0.5, 1e-14);  // a quadrangle
    EXPECT_NEAR(area(section({Vec<3>::Zero(), -Vec<3>::UnitX()}, corners)), 0.5, 1e-14);        // its own face
    EXPECT_TRUE(section({Vec<3>::Zero(), Vec<3>::UnitX()}, corners).empty());
}

TEST(Cut, partsOfTrianglesAndLines) {
    const CuttingPlane plane{{0.5, 0, 0}, Vec<3>::UnitX()};
    const Corners3 triangle{{Vec<3>::Zero()}, {Vec<3>::UnitX()}, {Vec<3>::UnitY()}};
    EXPECT_NEAR(area(partLeft(plane, triangle)), 0.5 - 0.125, 1e-14);
    const auto line = partLeft(plane, {Vec<3>::UnitX(), Vec<3>::Zero()});
    ASSERT_TRUE(line);
    EXPECT_NEAR(((*line)[0] - (*line)[1]).norm(), 0.5, 1e-14);
    EXPECT_FALSE(partLeft(plane, {Vec<3>::UnitX(), Vec<3>(2, 0, 0)}));
    const auto cut = trace(plane, {triangle[0].x, triangle[1].x, triangle[2].x});
    ASSERT_TRUE(cut);
    EXPECT_NEAR(((*cut)[0] - (*cut)[1]).norm(), 0.5, 1e-14);
}

TEST(Skin, roundAndSharpEdges) {
    Points<3> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1}, {0, 0, -1}};
    const std::vector<Face<3>> faces{{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
    const auto edges = skinEdges(faces);
    EXPECT_EQ(edges.size(), 7u);
    EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const SkinEdge& e) { return e.count == 2; }), 2);
    const auto normals = cornerNormals(faces, x);
    EXPECT_GT((normals[0][0] - Vec<3>::UnitZ()).norm(), 0.01);   // rounded with the second
    EXPECT_LT((normals[0][1] - Vec<3>::UnitZ()).norm(), 1e-14);  // not with the third
    EXPECT_LT((normals[2][0] + Vec<3>::UnitY()).norm(), 1e-14);
}

}  // namespace
