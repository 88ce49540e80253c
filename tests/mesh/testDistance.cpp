// How far a point is from a face: against closed forms and against the nearest of many points of the face.

#include "mesh/distance.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace pfem;

namespace {

TEST(Distance, toASegment) {
    const Points<2> x{{1, 1}, {4, 5}};  // of length 5
    const auto distance = [&](double px, double py) { return distanceToFace<2>(x, {0, 1}, {px, py}); };
    EXPECT_NEAR(distance(1 - 4, 1 + 3), 5, 1e-14) << "beside its start";
    EXPECT_NEAR(distance(2.5 + 0.8, 3 - 0.6), 1, 1e-14) << "beside its middle";
    EXPECT_NEAR(distance(4 + 6, 5 + 8), 10, 1e-14) << "behind its end";
    EXPECT_NEAR(distance(1 - 3, 1 - 4), 5, 1e-14) << "before its start";
    EXPECT_NEAR(distance(2.5, 3), 0, 1e-14);
    EXPECT_EQ(nearestWeight<2>(x[0], x[1], {4, 5}), 1);
    EXPECT_NEAR(nearestWeight<2>(x[0], x[1], {1.75 + 8, 2 - 6}), 0.25, 1e-14);
}

TEST(Distance, ofWhatHasNoLength) {
    const Points<2> x{{1, 1}, {1, 1}};
    EXPECT_EQ(distanceToFace<2>(x, {0, 1}, {4, 5}), 5);
    const Points<3> flat{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_EQ(distanceToFace<3>(flat, {0, 1, 2}, {1.5, 3, 4}), 5);
}

TEST(Distance, toATriangle) {
    const Points<3> x{{0, 0, 1}, {4, 0, 1}, {0, 3, 1}};
    const auto distance = [&](double px, double py, double pz) {
        return distanceToFace<3>(x, {0, 1, 2}, {px, py, pz});
    };
    EXPECT_NEAR(distance(1, 1, -1), 2, 1e-14) << "under it";
    EXPECT_NEAR(distance(1, -3, 5), 5, 1e-14) << "beside an edge";
    EXPECT_NEAR(distance(-3, -4, 13), 13, 1e-14) << "beside a corner";
    EXPECT_NEAR(distance(2 + 0.6, 1.5 + 0.8, 1), 1, 1e-14) << "beside the long edge";
}

// No point of the face is nearer, and some point is hardly farther.
TEST(Distance, isTheLeastOfManyPoints) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1, 1);
    const auto vector = [&] { return Vec<3>(value(random), value(random), value(random)); };
    for (int k = 0; k < 50; ++k) {
        const Points<3> x{vector(), vector(), vector()};
        const Vec<3> point = 2 * vector();
        double least = 1e300;
        constexpr int n = 100;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j)
                least = std::min(least, (x[0] + i * (x[1] - x[0]) / n + j * (x[2] - x[0]) / n - point).norm());
        const double distance = distanceToFace<3>(x, {0, 1, 2}, point);
        EXPECT_LE(distance, least + 1e-14);
        EXPECT_GE(distance, least - 0.03);
    }
}

}  // namespace
