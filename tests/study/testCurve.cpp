#include <gtest/gtest.h>

#include <cmath>

#include "study/curve.hpp"

namespace pfem {
namespace {

TEST(Curve, isStraightBetweenSamplesAndMissingOutside) {
    const Curve curve{{0, 1, 3}, {0, 2, -2}};
    EXPECT_DOUBLE_EQ(valueAt(curve, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(valueAt(curve, 2), 0);
    EXPECT_DOUBLE_EQ(valueAt(curve, 3), -2);
    EXPECT_TRUE(std::isnan(valueAt(curve, -0.01)));
    EXPECT_TRUE(std::isnan(valueAt(curve, 3.01)));
    EXPECT_TRUE(std::isnan(valueAt({}, 0)));
}

TEST(Curve, missingSampleIsMissingOnBothSides) {
    const Curve curve{{0, 1, 2, 3}, {1, NAN, 1, 1}};
    EXPECT_TRUE(std::isnan(valueAt(curve, 0.5)));
    EXPECT_TRUE(std::isnan(valueAt(curve, 1.5)));
    EXPECT_DOUBLE_EQ(valueAt(curve, 2.5), 1);
    EXPECT_DOUBLE_EQ(valueAt(curve, 0), 1);
}

TEST(Curve, commonTimes) {
    EXPECT_EQ(commonTimes({{{0, 1, 3}, {0, 0, 0}}, {{0.5, 1, 2, 4}, {0, 0, 0, 0}}}),
              (std::vector<double>{0.5, 1, 2, 3}));
    EXPECT_TRUE(commonTimes({{{0, 1}, {0, 0}}, {{2, 3}, {0, 0}}}).empty());
    EXPECT_TRUE(commonTimes({{{0, 1}, {0, 0}}, {}}).empty());
}

TEST(Curve, spansAndFractionsOfUnevenTimes) {
    const std::vector<double> t{0, 1, 2, 4, 5};
    const std::vector<bool> flag{true, false, true, true, false};
    const auto spans = spansWhere(t, flag);
    ASSERT_EQ(spans.size(), 2u);
    EXPECT_DOUBLE_EQ(spans[0].from, 0);
    EXPECT_DOUBLE_EQ(spans[0].to, 0.5);
    EXPECT_DOUBLE_EQ(spans[1].from, 1.5);
    EXPECT_DOUBLE_EQ(spans[1].to, 4.5);
    EXPECT_DOUBLE_EQ(fractionWhere(t, flag), 3.5 / 5);
    double sum = 0;
    for (const double w : weights(t)) sum += w;
    EXPECT_DOUBLE_EQ(sum, 5);
}

}  // namespace
}  // namespace pfem
