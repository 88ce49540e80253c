// Viscosities of generalised Newtonian and granular fluids against their laws.

#include <gtest/gtest.h>

#include "lawSamples.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

double stress(const std::string& type, const std::string& entries, double g, double p = 0) {
    return materialOf(type, entries).fluid.law->viscosity(g, p) * g;
}

TEST(Thinning, fromOneViscosityToTheOther) {
    for (const auto& [type, exponents] :
         {std::pair("carreau", "n 0.3;"), std::pair("carreau", "n 0.3; a 1;"), std::pair("cross", "m 0.8;")}) {
        const std::string entries = std::string("mu0 5; muInf 0.1; lambda 2; ") + exponents;
        EXPECT_NEAR(stress(type, entries, 1e-9) / 1e-9, 5, 1e-5);
        EXPECT_NEAR(stress(type, entries, 1e12) / 1e12, 0.1, 1e-3);
    }
    // in between, as powers: n - 1 of lambda g
    EXPECT_NEAR(stress("carreau", "mu0 5; muInf 0; lambda 2; n 0.3;", 500) / 500, 5 * std::pow(1000, -0.7), 1e-4);
    EXPECT_NEAR(stress("cross", "mu0 5; muInf 1; lambda 2; m 0.8;", 0.5) / 0.5, 3, 1e-12);
}

TEST(PowerLaw, isBounded) {
    const std::string entries = "k 7; n 0.4; muMin 0.5; muMax 100;";
    EXPECT_NEAR(stress("powerLaw", entries, 3), 7 * std::pow(3, 0.4), 1e-12);
    EXPECT_EQ(stress("powerLaw", entries, 1e-6), 100 * 1e-6);
    EXPECT_EQ(stress("powerLaw", entries, 1e6), 0.5 * 1e6);
}

TEST(Casson, squareRootsAdd) {
    for (const double g : {0.5, 4.0, 100.0})
        EXPECT_NEAR(std::sqrt(stress("casson", "muInf 2; tau0 50; m 1e4;", g)), std::sqrt(50) + std::sqrt(2 * g), 1e-9);
}

TEST(Granular, shearStressIsAPartOfThePressure) {
    EXPECT_NEAR(stress("druckerPrager", "frictionAngle 30; m 1e4;", 2, 800), 400, 1e-9);
    EXPECT_NEAR(stress("druckerPrager", "frictionAngle 30; cohesion 100; mu 3; m 1e4;", 2, 800),
                400 + 100 * std::cos(M_PI / 6) + 6, 1e-9);
    EXPECT_NEAR(stress("druckerPrager", "frictionAngle 30; cohesion 100; m 1e4;", 2, -800), 100 * std::cos(M_PI / 6),
                1e-9);
    const std::string grains = "muS 0.38; mu2 0.64; I0 0.3; grainSize 5e-4; grainDensity 2500; m 1e5;";
    EXPECT_NEAR(stress("muI", grains, 1e-2, 800), 0.38 * 800, 0.1);
    const double atI0 = 0.3 / (5e-4 * std::sqrt(2500 / 800.0));  // the shear rate with I = I0
    EXPECT_NEAR(stress("muI", grains, atI0, 800), 0.51 * 800, 1e-9);
    EXPECT_NEAR(stress("muI", grains, 1e9, 800), 0.64 * 800, 0.1);
}

}  // namespace
