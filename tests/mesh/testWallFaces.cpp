// Walls as one geometry: regions, how they go on, where points belong.

#include "mesh/wallFaces.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace pfem;

namespace {

/// A floor from (0 0) to (1 0), a rise of 10 degrees to (2 ...), a wall up, a step back.
struct Plane {
    Points<2> x = {{0, 0}, {1, 0}, {2, std::tan(10 * M_PI / 180)}, {2, 2}, {3, 2}};
    std::vector<Patch<2>> patches = {{"edge", {{4, 3}}}, {"floor", {{0, 1}, {1, 2}}}, {"side", {{2, 3}, {3, 4}}}};
    std::vector<WallFace<2>> walls = wallFaces<2>(patches, {false, true, true}, x);
};

TEST(WallFaces, regionsGoOverBendsAndPatches) {
    const Plane p;
    ASSERT_EQ(p.walls.size(), 5u);
    EXPECT_EQ(p.walls[0].patch, -1);
    EXPECT_EQ(p.walls[1].region, p.walls[2].region);
    EXPECT_NE(p.walls[2].region, p.walls[3].region);
    EXPECT_NE(p.walls[3].region, p.walls[4].region);
    EXPECT_EQ(p.walls[1].bend, (std::array{Bend::smooth, Bend::open}));  // beyond the second node, and the first
    EXPECT_EQ(p.walls[2].bend, (std::array{Bend::concave, Bend::smooth}));
    EXPECT_EQ(p.walls[3].bend, (std::array{Bend::convex, Bend::concave}));
    EXPECT_EQ(p.walls[2].next, (Face<2>{3, 1}));
    EXPECT_TRUE(p.walls[1].bent && p.walls[2].bent && !p.walls[3].bent);
    EXPECT_EQ(convexPairs<2>(p.walls).size(), 2u);  // both ways
}

TEST(WallFaces, pointsBelongToTheNearestFaceOfTheRegion) {
    const Plane p;
    const auto onFloor = placeOnRegion<2>(p.walls, p.x, 2, {0.5, 0.2});
    EXPECT_EQ(onFloor.face, 1);
    EXPECT_EQ(onFloor.beyond, -1);
    EXPECT_NEAR(onFloor.x[0], 0.5, 0.05);
    EXPECT_GT(onFloor.normal[1], 0.99);
    const auto again = placeOnRegion<2>(p.walls, p.x, 1, onFloor.x);  // what lies on it stays
    EXPECT_LT((again.x - onFloor.x).norm(), 1e-12);
    const auto before = placeOnRegion<2>(p.walls, p.x, 2, {-0.5, 0.1});
    EXPECT_EQ(before.face, 1);
    EXPECT_EQ(before.beyond, 1);  // the edge opposite to its second node
    EXPECT_EQ(before.x, p.x[0]);
    EXPECT_EQ(placeOnRegion<2>(p.walls, p.x, 1, {2.5, 0.2}).beyond, 0);
}

// The curve through the corners of a polygon is the circle, to fourth order.
TEST(WallFaces, polygonsAreMeantAsCurves) {
    double last = 0;
    for (const int n : {24, 48}) {
        Points<2> x;
        Patch<2> circle{"circle", {}};
        for (int k = 0; k < n; ++k) {
            x.push_back({std::cos(2 * M_PI * k / n), std::sin(2 * M_PI * k / n)});
            circle.faces.push_back({k, (k + 1) % n});  // the fluid is inside
        }
        const auto walls = wallFaces<2>({circle}, {true}, x);
        EXPECT_EQ(walls[0].region, walls[static_cast<std::size_t>(n) / 2].region);
        const Vec<2> off = 0.9 * (0.6 * x[0] + 0.4 * x[1]);
        const auto place = placeOnRegion<2>(walls, x, n / 3, off);
        const double error = std::abs(place.x.norm() - 1);
        EXPECT_LT(error, n == 24 ? 2e-4 : 2e-5);
        EXPECT_LT((place.normal + place.x.normalized()).norm(), 2e-3);
        if (last > 0) {
            EXPECT_GT(last / error, 12);
        }
        last = error;
    }
}

// The tip of a cone has no normal that its sides could be bent to: they stay straight towards it.
TEST(WallFaces, conesAreStraightTowardsTheirTip) {
    constexpr int n = 36;
    const double slope = M_PI / 6;
    Points<3> x{Vec<3>::Zero()};
    Patch<3> cone{"cone", {}};  // its tip down, the fluid below
    for (int k = 0; k < n; ++k) {
        const double a = 2 * M_PI * k / n;
        x.push_back({std::cos(a), std::sin(a), std::tan(slope)});
        cone.faces.push_back({0, k + 1, (k + 1) % n + 1});
    }
    const auto walls = wallFaces<3>({cone}, {true}, x);
    for (const auto& face : walls) EXPECT_EQ(face.region, walls[0].region);
    for (const double r : {0.1, 0.5, 0.9})
        for (const double a : {0.0, 0.4 * M_PI / n, M_PI / n, 2.0}) {
            const Vec<3> onCone(r * std::cos(a), r * std::sin(a), r * std::tan(slope));
            const Vec<3> normal(std::sin(slope) * std::cos(a), std::sin(slope) * std::sin(a), -std::cos(slope));
            const auto place = placeOnRegion<3>(walls, x, n / 2, onCone + 0.01 * normal);  // from beyond the tip
            EXPECT_LT((place.x - onCone).norm(), 2e-3) << r << " " << a;
            EXPECT_LT((place.normal - normal).norm(), 0.05) << r << " " << a;
        }
}

TEST(WallFaces, boxInThreeDimensions) {
    Points<3> x;
    for (int k = 0; k < 8; ++k) x.push_back({k & 1 ? 1.0 : 0.0, k & 2 ? 1.0 : 0.0, k & 4 ? 1.0 : 0.0});
    Patch<3> tank{"tank", {}};  // floor and two sides, area vectors out of the fluid
    for (const Face<3>& face : {Face<3>{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}, {0, 4, 2}, {2, 4, 6}})
        tank.faces.push_back(face);
    const auto walls = wallFaces<3>({tank}, {true}, x);
    EXPECT_EQ(walls[0].region, walls[1].region);
    EXPECT_EQ(walls[2].region, walls[3].region);
    EXPECT_NE(walls[0].region, walls[2].region);
    EXPECT_LT((inwardNormal<3>(x, walls[0].nodes) - Vec<3>(0, 0, 1)).norm(), 1e-12);
    int concave = 0, open = 0, smooth = 0;
    for (const auto& face : walls)
        for (const Bend bend : face.bend) {
            concave += bend == Bend::concave;
            open += bend == Bend::open;
            smooth += bend == Bend::smooth;
        }
    EXPECT_EQ(smooth, 6);   // the diagonals
    EXPECT_EQ(concave, 6);  // three edges
    EXPECT_EQ(open, 6);
    const auto place = placeOnRegion<3>(walls, x, 0, {0.9, 0.8, 0.3});
    EXPECT_EQ(place.face, 1);
    EXPECT_LT((place.x - Vec<3>(0.9, 0.8, 0)).norm(), 1e-12);
    EXPECT_EQ(placeOnRegion<3>(walls, x, 0, {0.5, -0.1, 0.3}).beyond >= 0, true);
}

}  // namespace
