#include <gtest/gtest.h>

#include "bounds/estimate.hpp"
#include "curves.hpp"

namespace pfem {
namespace {

using namespace test;

double u(double t) { return 3 * t - t * t; }

Estimate of(const Study& study) { return estimate(study, makeBand(study)); }

// A pure power law is extrapolated exactly, whatever its order; of order 2 without any uncertainty.
TEST(Estimate, exactForAPowerLaw) {
    for (const double order : {0.8, 1.5, 2.0, 2.7}) {
        const Study study = powerLaw(times(1, 50), u, {1, 0.6}, 0.3, 0.1, order);
        const Estimate e = of(study);
        EXPECT_EQ(e.obstacle, "");
        EXPECT_NEAR(e.order, order, 1e-12);
        double uncertainty = 0;
        for (std::size_t i = 0; i < study.t.size(); ++i) {
            EXPECT_NEAR(e.value[i], u(study.t[i]), 1e-12);
            uncertainty = std::max(uncertainty, e.uncertainty[i]);
        }
        if (order == 2)
            EXPECT_LT(uncertainty, 1e-12);
        else
            EXPECT_GT(uncertainty, 1e-3);
    }
}

// With a term of the fourth power the estimate is off, by less than its uncertainty; finer meshes make both
// smaller.
TEST(Estimate, uncertaintyHoldsTheError) {
    for (const int sizes : {2, 3}) {
        double last = 1;
        for (const double h : {0.8, 0.4, 0.2}) {
            Study study{{0, 1}, {}};
            for (int k = sizes - 1; k >= 0; --k) {
                const double size = h * (1 << k) / (1 << (sizes - 2));
                const double n = 0.2 * size * size - 0.02 * std::pow(size, 4),
                             e = 0.1 * size * size + 0.01 * std::pow(size, 4);
                study.twins.push_back({size, {0, 1 + n}, {0, 1 - e}});
            }
            const Estimate e = of(study);
            ASSERT_EQ(e.obstacle, "");
            EXPECT_LT(std::abs(e.value[1] - 1), e.uncertainty[1]) << sizes << " sizes, h " << h;
            EXPECT_LT(e.uncertainty[1], 0.25 * last);
            last = e.uncertainty[1];
        }
    }
}

// Known peaks of a cantilever (two meshes): the limit 6.88.
TEST(Estimate, peaksOfTheCantilever) {
    const Study study{{0, 1}, {{1, {0, 7.520}, {0, 6.069}}, {0.5, {0, 7.056}, {0, 6.650}}}};
    const Estimate e = of(study);
    EXPECT_NEAR(e.order, 1.84, 0.01);
    EXPECT_NEAR(e.value[1], 6.875, 0.02);
    EXPECT_GT(e.uncertainty[1], 0.005);
    EXPECT_LT(e.uncertainty[1], 0.25);
}

TEST(Estimate, thirdSizeWidensTheUncertainty) {
    Study study = powerLaw(times(1, 10), u, {2, 1, 0.5}, 0.02, 0.01, 2);
    EXPECT_LT(of(study).uncertainty.back(), 1e-12);
    for (double& y : study.twins[0].nodal) y *= 1.05;
    EXPECT_NEAR(of(study).value.back(), u(1), 1e-12);
    EXPECT_GT(of(study).uncertainty.back(), 0.01);
}

TEST(Estimate, noneWhereItWouldMeanNothing) {
    EXPECT_NE(of(powerLaw(times(1, 10), u, {1}, 0.3, 0.1, 2)).obstacle, "");
    EXPECT_NE(of(powerLaw(times(1, 10), u, {1, 0.5}, 0.3, 0.1, 0.2)).obstacle, "");
    EXPECT_NE(of(powerLaw(times(1, 10), u, {1, 0.5}, 0.3, 0.1, -1)).obstacle, "");
    EXPECT_NE(of(powerLaw(times(1, 10), u, {1, 0.5}, 0, 0, 1)).obstacle, "");
    Study study = powerLaw(times(1, 10), u, {1, 0.5}, 0.3, 0.1, 2);
    std::swap(study.twins[1].nodal[9], study.twins[1].elemental[9]);  // crossed there
    const Estimate e = of(study);
    EXPECT_EQ(e.obstacle, "");
    EXPECT_TRUE(std::isnan(e.value[9]));
    EXPECT_FALSE(std::isnan(e.value[8]));
}

}  // namespace
}  // namespace pfem
