// Waves that go on as they are, against the equations of potential flow; waves that come back, against what was put in.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>

#include "base/error.hpp"
#include "dictionary/function1.hpp"
#include "waves/dispersion.hpp"
#include "waves/permanentWave.hpp"
#include "waves/reflection.hpp"
#include "waves/secondOrderPiston.hpp"

using namespace pfem;

namespace {

/// Which part of g H the Bernoulli sum varies by along the surface, with the stream function that fits best,
///     psi = - u y + sum_j B_j sinh j k y/cosh j k d cos j theta = - c d on it.
double bernoulliError(const PermanentWave& wave, const RegularWave& of) {
    constexpr int nPoints = 60, nTerms = 12;
    const double d = of.depth;
    Eigen::MatrixXd A(nPoints, nTerms + 1);
    std::vector<double> height, theta;
    const auto share = [&](int j, double y) { return std::sinh(j * wave.k * y) / std::cosh(j * wave.k * d); };
    const auto rise = [&](int j, double y) {
        return j * wave.k * std::cosh(j * wave.k * y) / std::cosh(j * wave.k * d);
    };
    for (int n = 0; n < nPoints; ++n) {
        theta.push_back(M_PI * n / (nPoints - 1));
        height.push_back(d + wave.surface(theta[n]));
        A(n, 0) = -height[n];
        for (int j = 1; j <= nTerms; ++j) A(n, j) = share(j, height[n]) * std::cos(j * theta[n]);
    }
    const Eigen::VectorXd B = A.colPivHouseholderQr().solve(Eigen::VectorXd::Constant(nPoints, -wave.c * d));
    double low = 1e300, high = -1e300;
    for (int n = 0; n < nPoints; ++n) {
        double u = -B[0], v = 0;
        for (int j = 1; j <= nTerms; ++j) {
            u += B[j] * rise(j, height[n]) * std::cos(j * theta[n]);
            v += j * wave.k * B[j] * share(j, height[n]) * std::sin(j * theta[n]);
        }
        const double R = 0.5 * (u * u + v * v) + of.gravity * height[n];
        low = std::min(low, R);
        high = std::max(high, R);
    }
    return (high - low) / (of.gravity * of.height);
}

TEST(PermanentWaves, stokesOfFifthOrder) {
    const RegularWave low{0.05, 1.2, 0.5}, high{0.1, 1.2, 0.5};
    for (const auto& wave : {low, high}) {
        const auto stokes = stokesWave(wave);
        EXPECT_NEAR(stokes.surface(0) - stokes.surface(M_PI), wave.height, 1e-12);
        EXPECT_NEAR(stokes.k * stokes.c, 2 * M_PI / wave.period, 1e-12);
    }
    EXPECT_LT(bernoulliError(stokesWave(high), high), 1e-3);
    EXPECT_LT(bernoulliError(stokesWave(low), low), bernoulliError(stokesWave(high), high) / 25);  // 2^5
    const auto flat = stokesWave({1e-5, 1.2, 0.5});
    EXPECT_NEAR(flat.k, waveNumber(2 * M_PI / 1.2, 0.5, 9.81), 1e-7);
    // Stokes' second harmonic: k a^2/4 cosh q (2 + cosh 2q)/sinh^3 q
    const double q = flat.k * 0.5, a = 5e-6;
    EXPECT_NEAR(flat.amplitude[1],
                flat.k * a * a / 4 * std::cosh(q) * (2 + std::cosh(2 * q)) / std::pow(std::sinh(q), 3), 1e-6 * a * a);
}

TEST(PermanentWaves, cnoidal) {
    const RegularWave low{0.02, 4, 0.4}, high{0.04, 4, 0.4}, long_{0.04, 12, 0.4};
    for (const auto& wave : {low, high, long_}) {
        const auto cnoidal = cnoidalWave(wave);
        EXPECT_NEAR(cnoidal.surface(0) - cnoidal.surface(M_PI), wave.height, 1e-9);
        EXPECT_NEAR(cnoidal.k * cnoidal.c, 2 * M_PI / wave.period, 1e-9);
    }
    EXPECT_LT(bernoulliError(cnoidalWave(high), high), 0.1);
    EXPECT_LT(bernoulliError(cnoidalWave(low), low), 0.6 * bernoulliError(cnoidalWave(high), high));
    // a long one is a row of solitary waves: a sech^2(sqrt(3 H/(4 d^3)) x) less its mean
    const auto row = cnoidalWave(long_);
    const double x = 0.7, K = std::sqrt(0.75 * 0.04 / std::pow(0.4, 3));
    EXPECT_NEAR(row.surface(row.k * x) - row.surface(M_PI), 0.04 / std::pow(std::cosh(K * x), 2), 2e-4 * 0.04);
}

// The plate goes as fast as the water before it: X' = c eta/(d + eta).
TEST(PermanentWaves, thePistonGoesWithTheWater) {
    const auto wave = stokesWave({0.1, 1.2, 0.5});
    const PermanentMotion motion(wave, 0.5);
    EXPECT_NEAR(motion.value(0), 0, 1e-14);
    EXPECT_NEAR(motion.value(1.2 + 0.3), motion.value(0.3), 1e-12);
    for (const double t : {0.1, 0.5, 0.9}) {
        const double speed = (motion.value(t + 1e-5) - motion.value(t - 1e-5)) / 2e-5;
        const double eta = wave.surface(wave.k * (wave.c * t - motion.value(t)));
        EXPECT_NEAR(speed, wave.c * eta / (0.5 + eta), 1e-7);
    }
}

// Long waves: Madsen's H^2/(32 d) (3 cosh q/sinh^3 q - 2/m) sin 2wt, off by a quarter of q^4. Linear in the square of
// the stroke.
TEST(SecondOrderPiston, isMadsensForLongWaves) {
    const double d = 0.4, g = 9.81, H = 0.02;
    double last = 1;
    for (const double q : {0.4, 0.2, 0.1}) {
        const double omega = std::sqrt(g * q / d * std::tanh(q)), m = makerGain(Maker::piston, q);
        const double madsen = H * H / (32 * d) * (3 * std::cosh(q) / std::pow(std::sinh(q), 3) - 2 / m);
        const auto second = secondOrderStroke({0, -0.5 * H / m}, omega, d, g);
        const double off = std::abs(second - std::complex<double>(0, -madsen)) / madsen;
        EXPECT_LT(off, 0.1 * last);
        last = off;
        const auto turned = secondOrderStroke({-H / m, 0}, omega, d, g);  // twice as long, a quarter of a period before
        EXPECT_LT(std::abs(turned - 4.0 * -second), 1e-12 * std::abs(turned));
    }
    EXPECT_LT(last, 1e-4);
}

TEST(PermanentWaves, entries) {
    const auto read = [](const std::string& entries) {
        return readFunction1<double>(Dictionary::parse("f { type waveMaker; depth 0.5; height 0.1; " + entries + " }"),
                                     "f");
    };
    const auto wave = stokesWave({0.1, 1.2, 0.5});
    EXPECT_NEAR(read("theory stokes5; period 1.2; ramp 0;")->value(0.4), PermanentMotion(wave, 0.5).value(0.4), 1e-14);
    EXPECT_NEAR(read("theory stokes5; period 1.2; ramp 0; maker inlet;")->value(0.4),
                wave.c * wave.surface(wave.k * wave.c * 0.4), 1e-14);
    const double omega = 2 * M_PI / 1.2;
    EXPECT_NEAR(read("period 1.2; ramp 0; maker inlet;")->value(0.4),
                0.05 * std::sin(omega * 0.4) * omega / waveNumber(omega, 0.5, 9.81), 1e-14);
    EXPECT_NO_THROW(read("theory cnoidal; period 5;"));
    for (const char* bad : {"theory cnoidal; period 1.2;", "theory stokes5; period 8;",
                            "theory stokes5; period 1.2; maker flap;", "theory solitary; maker inlet;"})
        EXPECT_THROW(read(bad), UserError) << bad;
}

TEST(Reflection, whatWasPutInComesOut) {
    const std::complex<double> incident(0.03, -0.01), reflected(-0.002, 0.004), i(0, 1);
    const double k = 2.3;
    for (const std::vector<double>& x : {std::vector<double>{0, 0.5}, {0.1, 0.5, 1.1}, {0, 0.3, 0.7, 1.9}}) {
        std::vector<std::complex<double>> A;
        for (const double at : x) A.push_back(incident * std::exp(-i * k * at) + reflected * std::exp(i * k * at));
        const auto waves = separateWaves(x, A, k);
        ASSERT_TRUE(waves);
        EXPECT_LT(std::abs(waves->incident - incident), 1e-15);
        EXPECT_LT(std::abs(waves->reflected - reflected), 1e-15);
    }
    EXPECT_FALSE(separateWaves({0, M_PI / k}, {1, -1}, k));  // half a wave length apart
    EXPECT_TRUE(separateWaves({0, 0.4, M_PI / k}, {1, 0.5, -1}, k));
}

}  // namespace
