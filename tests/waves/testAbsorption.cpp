// The wall that gives way to waves, by linear theory: once it moves as it should it goes on so.

#include <gtest/gtest.h>

#include <complex>

#include "conditions/wallMotion.hpp"
#include "waves/dispersion.hpp"

using namespace pfem;

namespace {

using Complex = std::complex<double>;
constexpr Complex i(0, 1);

Absorption wallOf(const std::string& text) { return *WallMotion(Dictionary::parse(text, "motion"), true).absorption(); }

/// Largest difference of the answer to a wave of amplitude 1 and of what throws nothing back, over 1 period of `steps`.
double errorOf(double kd, int steps) {
    const double d = 0.4, k = kd / d, omega = std::sqrt(9.81 * k * std::tanh(kd)), T = 2 * M_PI / omega, dt = T / steps;
    const Absorption wall = wallOf("absorb { depth 0.4; period " + std::to_string(T) + "; }");
    const double c = makerGain(Maker::piston, kd), n = nearFieldGain(kd);
    const Complex U = -omega / c, eta = 2.0 + (c - i * n) * U / omega;
    double error = 0;
    for (int m = 0; m < steps; ++m) {
        const double t = m * dt;
        const auto at = [&](const Complex& amplitude, double time) {
            return std::real(amplitude * std::polar(1.0, omega * time));
        };
        const double answer = wall.answer(at(U, t), at(U / (i * omega), t), at(eta, t + wall.ahead(dt)), dt);
        error = std::max(error, std::abs(answer - at(U, t + dt)) / std::abs(U));
    }
    return error / (2 * M_PI / steps);  // of what it changes by in a step
}

TEST(Absorption, aWallThatThrowsNothingBackGoesOnSo) {
    for (const double kd : {0.5, 1.0, 3.0}) {
        EXPECT_LT(errorOf(kd, 60), 0.02) << kd;
        EXPECT_LT(errorOf(kd, 240), 0.35 * errorOf(kd, 120)) << kd;
    }
}

TEST(Absorption, itComesBackAndKnowsItsOwnWaves) {
    const Absorption wall = wallOf("absorb { depth 0.4; period 1.4; }");
    double way = 0.1, U = 0;
    for (int m = 0; m < 2000; ++m) {  // no waves
        const double next = wall.answer(U, way, 0, 0.02);
        way += 0.01 * (U + next);
        U = next;
    }
    EXPECT_NEAR(way, 0, 1e-4);
    const Absorption maker =
        wallOf("displacement { type waveMaker; depth 0.4; height 0.04; period 1.4; ramp 0; } absorb { }");
    EXPECT_EQ(maker.depth, 0.4);
    const Eigen::Vector3d right = Eigen::Vector3d::UnitX();
    const double crest = maker.own(1.4 * 3, right);  // of H/2 cos wt
    EXPECT_NEAR(crest, 0.02, 1e-12);
    EXPECT_EQ(maker.own(1.4 * 3, -right), -crest);  // at the other end the same motion makes a trough
    const Absorption mirrored = wallOf(
        "displacement { type waveMaker; depth 0.4; height 0.04; period 1.4; ramp 0; scale (-1 0 0); } absorb { }");
    EXPECT_EQ(mirrored.own(1.4 * 3, -right), crest);
    EXPECT_LT(maker.answer(0, 0, 0.01, 0.02), 0);  // away from a crest
}

TEST(Absorption, badEntries) {
    EXPECT_THROW(wallOf("absorb { depth 0.4; }"), UserError);
    EXPECT_THROW(wallOf("absorb { depth 0; period 1; }"), UserError);
    EXPECT_THROW(wallOf("velocity (1 0 0); absorb { depth 1; period 1; }"), UserError);
    EXPECT_THROW(wallOf("displacement (1 0 0); absorb { depth 1; period 1; }"), UserError);
    EXPECT_THROW(wallOf("absorb { depth 1; period 1; up (0 0 1); }"), UserError);
}

}  // namespace
