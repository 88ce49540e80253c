// Viscosity of generalised Newtonian fluids against the laws it regularises.

#include <gtest/gtest.h>

#include <cmath>

#include "material/herschelBulkley.hpp"
#include "material/newtonian.hpp"
#include "material/viscosity.hpp"

using namespace pfem;

namespace {

YieldingFlow flow(double tau0, double k, double n, double m) { return {k, n, tau0, m}; }

TEST(Viscosity, newtonianDoesNotDependOnTheFlow) {
    EXPECT_EQ(newtonian(3)->viscosity(0, 0), 3);
    EXPECT_EQ(newtonian(3)->viscosity(1e6, 0), 3);
    EXPECT_FALSE(newtonian(3)->dependsOnFlow());
    EXPECT_FALSE(flow(0, 3, 1, 1000).dependsOnFlow());
    EXPECT_EQ(flow(0, 3, 1, 1000).viscosity(1e6), 3);
}

// Far above 1/m the stress is tau0 + k g^n; the regularised stress never exceeds tau0 where k = 0.
TEST(Viscosity, stressIsThatOfTheLaw) {
    for (const double n : {0.4, 1.0, 1.7}) {
        const auto fluid = flow(50, 7, n, 1e4);
        for (const double g : {0.01, 0.5, 20.0})
            EXPECT_NEAR(fluid.viscosity(g) * g, 50 + 7 * std::pow(g, n), 1e-3 * 50) << n << " " << g;
    }
}

TEST(Viscosity, atRestItCreeps) {
    EXPECT_NEAR(flow(50, 7, 1, 1e3).viscosity(0), 50 * 1e3 + 7, 1e-9);
    EXPECT_NEAR(flow(50, 7, 1, 1e3).viscosity(1e-9), 50 * 1e3 + 7, 1);
    EXPECT_NEAR(flow(0, 7, 0.5, 1e4).viscosity(0), 7 * 100, 1e-9);  // thinning: bounded
}

TEST(Viscosity, stressGrowsWithTheRate) {
    for (const double n : {0.3, 1.0, 1.5}) {
        double last = 0;
        for (double g = 1e-7; g < 1e3; g *= 1.3) {
            const double stress = flow(50, 7, n, 1e3).viscosity(g) * g;
            EXPECT_GT(stress, last);
            last = stress;
        }
    }
}

TEST(Viscosity, slopeIsTheDerivative) {
    for (const double n : {0.4, 1.0, 1.7})
        for (const double g : {1e-6, 1e-3, 0.02, 1.0, 30.0}) {
            const auto fluid = flow(50, 7, n, 100);
            const double eps = 1e-4 * g, slope = (fluid.viscosity(g + eps) - fluid.viscosity(g - eps)) / (2 * eps);
            EXPECT_NEAR(fluid.slope(g), slope, 1e-4 * std::abs(slope) + 1e-6) << n << " " << g;
        }
}

// g of simple shear is the shear; turning makes none; stretching by e in the plane: 2 e.
TEST(ShearRate, ofSimpleFlows) {
    Tensor<2> L;
    L << 0, 4, 0, 0;
    EXPECT_NEAR(shearRate<2>(L), 4, 1e-14);
    L << 0, 4, -4, 0;
    EXPECT_NEAR(shearRate<2>(L), 0, 1e-14);
    L << 3, 0, 0, -3;
    EXPECT_NEAR(shearRate<2>(L), 6, 1e-14);
    EXPECT_NEAR(shearRate<3>(Tensor<3>::Identity()), 0, 1e-14);
    EXPECT_NEAR(viscousStress<2>(5, L)(0, 0), 30, 1e-13);
}

}  // namespace
