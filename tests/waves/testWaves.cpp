// Wave theory against its limits and its own equations.

#include <gtest/gtest.h>

#include "dictionary/function1.hpp"
#include "waves/makerSignal.hpp"

using namespace pfem;

namespace {

TEST(Waves, dispersion) {
    for (const double T : {0.3, 0.8, 2.0, 15.0}) {
        const double omega = 2 * M_PI / T, k = waveNumber(omega, 0.5, 9.81);
        EXPECT_NEAR(9.81 * k * std::tanh(0.5 * k), omega * omega, 1e-12 * omega * omega);
    }
}

TEST(Waves, gainsOfWaveMakers) {
    EXPECT_NEAR(makerGain(Maker::piston, 0.01), 0.01, 1e-6);  // long waves: H/S = k d, half of it of a flap
    EXPECT_NEAR(makerGain(Maker::flap, 0.01), 0.005, 1e-6);
    EXPECT_NEAR(makerGain(Maker::piston, 30), 2, 1e-12);
    EXPECT_NEAR(makerGain(Maker::flap, 30), 2 * (1 - 1 / 30.), 1e-12);
    for (const auto maker : {Maker::piston, Maker::flap})
        EXPECT_NEAR(makerGain(maker, 20 - 1e-9), makerGain(maker, 20 + 1e-9), 1e-9);
    EXPECT_NEAR(makerGain(Maker::piston, 1), 2 * (std::cosh(2) - 1) / (std::sinh(2) + 2), 1e-15);
}

// Sums of 2000 terms. With all of them the water that a piston pushes is in the waves: c/q + sum_j c_j/q_j = 1 to
// 1e-11.
TEST(Waves, nearFieldOfAPiston) {
    EXPECT_NEAR(nearFieldGain(0.01), 7.7534e-10, 1e-13);
    EXPECT_NEAR(nearFieldGain(1), 0.057397, 1e-6);
    EXPECT_NEAR(nearFieldGain(3), 0.870238, 1e-5);
}

// A quarter of a period after the piston in long waves, nearer in short ones.
TEST(Waves, surfaceAtAPiston) {
    const Flume flume{0.4};
    const double q = 3, omega = std::sqrt(9.81 * q / 0.4 * std::tanh(q));
    const auto surface = surfaceAtPiston({{0.01, omega, 0}}, flume);
    for (const double t : {0.0, 0.1, 0.3})
        EXPECT_NEAR(sumAt(surface, t),
                    0.01 * (makerGain(Maker::piston, q) * std::cos(omega * t) + 0.870238 * std::sin(omega * t)), 1e-7);
    const auto regular = regularSurface(0.04, 1.2, false, flume), bound = regularSurface(0.04, 1.2, true, flume);
    EXPECT_NEAR(sumAt(regular, 0), 0.02, 1e-12);  // a crest; at half the period a trough, which is flatter
    EXPECT_GT(sumAt(bound, 0), 0.02);
    EXPECT_NEAR(sumAt(bound, 0) + sumAt(bound, 0.6), 2 * bound[1].amplitude, 1e-12);
}

TEST(Waves, surfaceIsAQuarterOfAPeriodBehindTheMotion) {
    const Flume flume{0.4};
    const auto piston = regularMotion(0.02, 1.2, false, flume);
    const auto again = motionFor({{0.01, 2 * M_PI / 1.2, M_PI / 2}}, flume);
    for (const double t : {0.1, 0.4, 1.1}) EXPECT_NEAR(sumAt(piston, t), sumAt(again, t), 1e-15);
    EXPECT_NEAR(rateAt(piston, 0.3), (sumAt(piston, 0.3 + 1e-5) - sumAt(piston, 0.3 - 1e-5)) / 2e-5, 1e-8);
}

TEST(Waves, seaHasItsHeightAndPeak) {
    const Sea sea{0.1, 1.5, 3.3, 400};
    const auto sines = surfaceOf(sea);
    double m0 = 0, m1 = 0, mostEnergy = 0, peak = 0;
    for (const auto& s : sines) {
        m0 += 0.5 * s.amplitude * s.amplitude;
        m1 += 0.5 * s.amplitude * s.amplitude * s.omega;
        if (s.amplitude > mostEnergy) mostEnergy = s.amplitude, peak = s.omega;
    }
    EXPECT_NEAR(4 * std::sqrt(m0), 0.1, 1e-14);
    EXPECT_NEAR(2 * M_PI / peak, 1.5, 0.02);
    double energy = 0, moment = 0;  // of the continuous spectrum
    for (double r = 0.50005; r < 3; r += 1e-4) {
        energy += jonswapShape(r, 3.3);
        moment += r * jonswapShape(r, 3.3);
    }
    EXPECT_NEAR(2 * M_PI * m0 / m1 / 1.5, energy / moment, 0.005);  // T_m01
    EXPECT_NEAR(jonswapShape(1, 3.3) / jonswapShape(1, 1), 3.3, 1e-14);
    EXPECT_EQ(surfaceOf(sea)[17].phase, sines[17].phase);
    EXPECT_NE(surfaceOf({0.1, 1.5, 3.3, 400, 2})[17].phase, sines[17].phase);
}

TEST(Waves, focusedGroupMeets) {
    const auto sines = focusedGroup({0.1, 1.5}, {0.05, 8, 3}, 0.5, 9.81);
    double there = 0, later = 0;
    for (const auto& s : sines) {
        const double k = waveNumber(s.omega, 0.5, 9.81);
        there += s.amplitude * std::sin(s.omega * 8 - k * 3 + s.phase);
        later += s.amplitude * std::sin(s.omega * 13 - k * 3 + s.phase);
    }
    EXPECT_NEAR(there, 0.05, 1e-14);
    EXPECT_LT(std::abs(later), 0.02);
}

// The plate goes as fast as the water before it: X' = c eta/(d + eta).
TEST(Waves, solitaryPiston) {
    const double a = 0.09, d = 0.3, c = std::sqrt(9.81 * (d + a)), K = std::sqrt(3 * a / (4 * d * d * (d + a)));
    const SolitaryMotion motion(a, {d});
    EXPECT_NEAR(motion.value(0), 0, 1e-15);
    EXPECT_NEAR(motion.value(60), 1.998 * a / (K * d), 1e-9);
    for (const double t : {0.3, 0.7, 1.0, 1.4}) {
        const double speed = (motion.value(t + 1e-5) - motion.value(t - 1e-5)) / 2e-5;
        const double th = motion.value(t) * K * d / a - 0.998, eta = a * (1 - th * th);
        EXPECT_NEAR(speed, c * eta / (d + eta), 1e-7);
    }
}

TEST(Waves, wordsOfTheDictionary) {
    const auto dict = Dictionary::parse(
        "a { type waveMaker; depth 0.4; height 0.02; period 1.2; ramp 2; } b { type waveMaker; theory solitary; depth "
        "0.4; height 0.1; start 1; scale (2 0 0); } c { type waveMaker; maker flap; depth 0.4; height 0.02; period 1; "
        "} "
        "d { type waveMaker; maker flap; theory solitary; depth 0.4; height 0.02; }");
    const auto a = readFunction1<Eigen::Vector3d>(dict, "a");
    EXPECT_NEAR(a->value(5.3)[0], sumAt(regularMotion(0.02, 1.2, false, {0.4}), 5.3), 1e-15);
    EXPECT_NEAR(a->value(1)[0], 0.5 * sumAt(regularMotion(0.02, 1.2, false, {0.4}), 1), 1e-15);
    const auto b = readFunction1<Eigen::Vector3d>(dict, "b");
    EXPECT_EQ(b->value(0.9)[0], 0);
    EXPECT_NEAR(b->value(2.5)[0], 2 * SolitaryMotion(0.1, {0.4}).value(1.5), 1e-15);
    EXPECT_NEAR(std::tan(readFunction1<double>(dict, "c")->value(7.1)) * 0.4,
                sumAt(regularMotion(0.02, 1, false, {0.4, 9.81, Maker::flap}), 7.1), 1e-15);
    EXPECT_THROW(readFunction1<double>(dict, "d"), UserError);
}

}  // namespace
