// Hyperelastic laws against closed forms.

#include <gtest/gtest.h>

#include "lawSamples.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

const Tensor<3> I = Tensor<3>::Identity();

Stress<3> stressAt(const std::string& type, const std::string& entries, const Tensor<3>& F) {
    return LawAtPoint<3>(type, entries).go(I, F);
}

/// sigma_11 - sigma_22 of an incompressible bar stretched to `stretch`: its tension.
double tension(const std::string& type, const std::string& entries, double stretch) {
    const double lateral = 1 / std::sqrt(stretch);
    const Stress<3> sigma = stressAt(type, entries, Vec<3>(stretch, lateral, lateral).asDiagonal());
    EXPECT_NEAR(sigma[1], sigma[2], 1e-9 * sigma.norm());
    return sigma[0] - sigma[1];
}

TEST(MooneyRivlin, barAndShear) {
    const std::string entries = "C10 3e4; C01 1e4; nu 0.49;";
    for (const double l : {0.6, 1.5, 2.5})
        EXPECT_NEAR(tension("mooneyRivlin", entries, l), 2 * (l * l - 1 / l) * (3e4 + 1e4 / l), 1e-6);
    Tensor<3> F = I;
    const double g = F(0, 1) = 0.8;
    const Stress<3> sigma = stressAt("mooneyRivlin", entries, F);
    EXPECT_NEAR(sigma[3], 2 * 4e4 * g, 1e-8);
    EXPECT_NEAR(sigma[0] - sigma[1], 2 * 4e4 * g * g, 1e-8);
    EXPECT_NEAR(sigma[1] - sigma[2], -2 * 1e4 * g * g, 1e-8);  // the second normal stress difference is that of C01
}

TEST(Yeoh, bar) {
    for (const double l : {0.7, 1.5, 3.0}) {
        const double i = l * l + 2 / l - 3, slope = 4e4 - 2 * 2e3 * i + 3 * 500 * i * i;
        EXPECT_NEAR(tension("yeoh", "C1 4e4; C2 -2e3; C3 500; nu 0.49;", l), 2 * (l * l - 1 / l) * slope, 1e-5);
    }
}

TEST(Ogden, bar) {
    for (const double l : {0.7, 1.5, 3.0}) {
        double exact = 0;
        for (const auto& [mu, alpha] : {std::pair(6e4, 1.3), std::pair(1e2, 5.0), std::pair(-1e4, -2.0)})
            exact += mu * (std::pow(l, alpha) - std::pow(l, -0.5 * alpha));
        EXPECT_NEAR(tension("ogden", solidSamples.at("ogden"), l), exact, 1e-8 * std::abs(exact));
    }
}

// Exponents 2 and -2 are Mooney and Rivlin's, in any deformation.
TEST(Ogden, isMooneyRivlin) {
    Tensor<3> F;
    F << 1.4, -0.5, 0.2, 0.3, 0.8, 0.1, -0.3, 0.2, 1.2;
    const Stress<3> a = stressAt("ogden", "mu (6e4 -2e4); alpha (2 -2); nu 0.4;", F);
    const Stress<3> b = stressAt("mooneyRivlin", "C10 3e4; C01 1e4; nu 0.4;", F);
    EXPECT_LT((a - b).norm(), 1e-10 * b.norm());
}

// P_11 = (lambda + 2 mu)(l^3 - l)/2 at uniaxial strain.
TEST(StVenantKirchhoff, uniaxialStrain) {
    const IsotropicElasticity elastic{2e5, 0.3};
    for (const double l : {0.8, 1.2, 1.6}) {
        const Tensor<3> F = Vec<3>(l, 1, 1).asDiagonal();
        const Stress<3> sigma = stressAt("stVenantKirchhoff", solidSamples.at("stVenantKirchhoff"), F);
        EXPECT_NEAR(sigma[0], (elastic.lambda() + 2 * elastic.mu()) * (l * l * l - l) / 2, 1e-8);
        EXPECT_NEAR(sigma[1] * l, elastic.lambda() * (l * l - 1) / 2, 1e-8);
    }
}

// A sudden shear that is held relaxes as sum_k beta_k exp(-t/tau_k), and keeps turning with the body.
TEST(Viscoelastic, relaxation) {
    LawAtPoint<3> point("viscoelastic", "E 2.8e5; nu 0.4; ratios (0.5 2); times (0.1 10);");
    const double mu = 1e5, g = 1e-4, dt = 1e-3;
    Tensor<3> F = I;
    F(0, 1) = g;
    EXPECT_NEAR(point.go(I, F, 1e-12)[3], mu * g * 3.5, 1e-3 * mu * g);
    double t = 0;
    for (const double until : {0.05, 0.3}) {
        Stress<3> sigma;
        for (; t < until - 0.5 * dt; t += dt) sigma = point.go(F, F, dt);
        EXPECT_NEAR(sigma[3], mu * g * (1 + 0.5 * std::exp(-until / 0.1) + 2 * std::exp(-until / 10)), 1e-3 * mu * g);
    }
}

// A quick branch is a dashpot: tau = mu g + beta tau mu dg/dt.
TEST(Viscoelastic, quickBranchesAreDashpots) {
    LawAtPoint<3> point("viscoelastic", "E 2.8e5; nu 0.4; ratios (100); times (1e-4);");
    const double mu = 1e5, rate = 0.01, dt = 0.01;
    Tensor<3> F = I, next = I;
    Stress<3> sigma;
    for (int k = 0; k < 20; ++k, F = next) {
        next(0, 1) += rate * dt;
        sigma = point.go(F, next, dt);
    }
    EXPECT_NEAR(sigma[3], mu * next(0, 1) + 100 * 1e-4 * mu * rate, 1e-3 * mu * rate * 0.01);
}

// Sinusoidal shear: the work lost in a cycle is pi g^2 G'', G'' = mu sum beta w tau/(1 + (w tau)^2).
TEST(Viscoelastic, lossOfACycle) {
    LawAtPoint<3> point("viscoelastic", "E 2.8e5; nu 0.4; ratios (0.5 2); times (0.1 1);");
    const double mu = 1e5, g = 1e-3, w = 5;
    const int perCycle = 400;
    double work = 0, last = 0;
    Tensor<3> F = I;
    for (int k = 1; k <= 8 * perCycle; ++k) {
        Tensor<3> next = I;
        next(0, 1) = g * std::sin(2 * M_PI * k / perCycle);
        const double tau = point.go(F, next, 2 * M_PI / w / perCycle)[3];
        if (k > 7 * perCycle) work += 0.5 * (tau + last) * (next(0, 1) - F(0, 1));
        last = tau;
        F = next;
    }
    double loss = 0;
    for (const auto& [beta, time] : {std::pair(0.5, 0.1), std::pair(2.0, 1.0)})
        loss += mu * beta * w * time / (1 + w * w * time * time);
    EXPECT_NEAR(work, M_PI * g * g * loss, 2e-3 * M_PI * g * g * loss);
}

}  // namespace
