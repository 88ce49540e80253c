// Viscosity of generalised Newtonian fluids against the laws it regularises.

#include <gtest/gtest.h>

#include <cmath>

#include "material/viscosity.hpp"

using namespace pfem;

namespace {

ViscousFluid herschelBulkley(double tau0, double k, double n, double m) {
    ViscousFluid fluid;
    fluid.yieldStress = tau0;
    fluid.mu = k;
    fluid.exponent = n;
    fluid.regularisation = m;
    return fluid;
}

TEST(Viscosity, newtonianDoesNotDependOnTheFlow) {
    ViscousFluid fluid;
    fluid.mu = 3;
    EXPECT_EQ(viscosity(fluid, 0), 3);
    EXPECT_EQ(viscosity(fluid, 1e6), 3);
}

// Far above 1/m the stress is tau0 + k g^n; the regularised stress never exceeds tau0 where k = 0.
TEST(Viscosity, stressIsThatOfTheLaw) {
    for (const double n : {0.4, 1.0, 1.7}) {
        const auto fluid = herschelBulkley(50, 7, n, 1e4);
        for (const double g : {0.01, 0.5, 20.0})
            EXPECT_NEAR(viscosity(fluid, g) * g, 50 + 7 * std::pow(g, n), 1e-3 * 50) << n << " " << g;
    }
}

TEST(Viscosity, atRestItCreeps) {
    EXPECT_NEAR(viscosity(herschelBulkley(50, 7, 1, 1e3), 0), 50 * 1e3 + 7, 1e-9);
    EXPECT_NEAR(viscosity(herschelBulkley(50, 7, 1, 1e3), 1e-9), 50 * 1e3 + 7, 1);
    EXPECT_NEAR(viscosity(herschelBulkley(0, 7, 0.5, 1e4), 0), 7 * 100, 1e-9);  // thinning: bounded
}

TEST(Viscosity, stressGrowsWithTheRate) {
    for (const double n : {0.3, 1.0, 1.5}) {
        double last = 0;
        for (double g = 1e-7; g < 1e3; g *= 1.3) {
            const double stress = viscosity(herschelBulkley(50, 7, n, 1e3), g) * g;
            EXPECT_GT(stress, last);
            last = stress;
        }
    }
}

TEST(Viscosity, slopeIsTheDerivative) {
    for (const double n : {0.4, 1.0, 1.7})
        for (const double g : {1e-6, 1e-3, 0.02, 1.0, 30.0}) {
            const auto fluid = herschelBulkley(50, 7, n, 100);
            const double eps = 1e-4 * g, slope = (viscosity(fluid, g + eps) - viscosity(fluid, g - eps)) / (2 * eps);
            EXPECT_NEAR(viscositySlope(fluid, g), slope, 1e-4 * std::abs(slope) + 1e-6) << n << " " << g;
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
