// The neo-Hookean law at one point.

#include "material/neoHookean.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "base/error.hpp"
#include "material/hypoelastic.hpp"

using namespace pfem;

namespace {

const IsotropicElasticity rubber{2e5, 0.3};

template <int Dim>
Tensor<Dim> strained() {
    Tensor<Dim> F = Tensor<Dim>::Identity();
    F(0, 0) = 1.4;
    F(0, 1) = -0.5;
    F(1, 0) = 0.2;
    F(Dim - 1, Dim - 1) = 0.8;
    return F;
}

template <int Dim>
Tensor<Dim> turned(double angle) {
    Tensor<Dim> R = Tensor<Dim>::Identity();
    R.template topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    if constexpr (Dim == 3) R = R * Eigen::AngleAxisd(0.7, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();
    return R;
}

template <int Dim>
void expectRotationInvariance() {
    const Tensor<Dim> F = strained<Dim>();
    const Stress<Dim> sigma = neoHookeanStress<Dim>(rubber, F);
    for (const double angle : {0.3, 1.57, 3.0}) {
        const Tensor<Dim> R = turned<Dim>(angle);
        const Tensor<Dim> expected = R * stressTensor<Dim>(sigma) * R.transpose();
        const Stress<Dim> found = neoHookeanStress<Dim>(rubber, R * F);
        EXPECT_LT((stressTensor<Dim>(found) - expected).norm(), 1e-14 * rubber.E);
        if (Dim == 2) {
            EXPECT_NEAR(found[2], sigma[2], 1e-14 * rubber.E);
        }
        EXPECT_NEAR(neoHookeanEnergy<Dim>(rubber, R * F), neoHookeanEnergy<Dim>(rubber, F), 1e-13 * rubber.E);
        EXPECT_LT(neoHookeanStress<Dim>(rubber, R).norm(), 1e-14 * rubber.E);  // a rigid rotation makes no stress
    }
}

TEST(NeoHookeanLaw, rotationInvariance) {
    expectRotationInvariance<2>();
    expectRotationInvariance<3>();
}

TEST(NeoHookeanLaw, smallStrainIsLinearElasticity) {
    Tensor<2> grad;
    grad << 0.7, 0.3, -0.9, 0.4;
    const auto error = [&](double eps) {
        const Tensor<2> D = 0.5 * eps * (grad + grad.transpose());
        const Stress<2> linear = elasticStress<2>(rubber, D);
        return (neoHookeanStress<2>(rubber, Tensor<2>::Identity() + eps * grad) - linear).norm() / linear.norm();
    };
    EXPECT_LT(error(1e-6), 1e-5);
    EXPECT_NEAR(error(1e-3) / error(1e-4), 10, 0.5);  // the difference is of second order
}

// P = dW/dF, in two and three dimensions; the zz stress of plane strain is that of three dimensions.
template <int Dim>
void expectStressOfTheEnergy() {
    const Tensor<Dim> F = strained<Dim>(), P = firstPiola<Dim>(neoHookeanStress<Dim>(rubber, F), F);
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) {
            Tensor<Dim> plus = F, minus = F;
            plus(i, j) += 1e-5;
            minus(i, j) -= 1e-5;
            const double slope = (neoHookeanEnergy<Dim>(rubber, plus) - neoHookeanEnergy<Dim>(rubber, minus)) / 2e-5;
            EXPECT_NEAR(P(i, j), slope, 1e-8 * rubber.E) << i << j;
        }
    EXPECT_EQ(neoHookeanEnergy<Dim>(rubber, Tensor<Dim>::Identity()), 0);
    EXPECT_GT(neoHookeanEnergy<Dim>(rubber, F), 1e3);
}

TEST(NeoHookeanLaw, stressIsTheDerivativeOfTheEnergy) {
    expectStressOfTheEnergy<2>();
    expectStressOfTheEnergy<3>();
}

TEST(NeoHookeanLaw, planeStrainIsTheThreeDimensionalLaw) {
    Tensor<3> F3 = Tensor<3>::Identity();
    F3.topLeftCorner<2, 2>() = strained<2>();
    const Stress<2> s2 = neoHookeanStress<2>(rubber, strained<2>());
    const Stress<3> s3 = neoHookeanStress<3>(rubber, F3);
    EXPECT_LT((s2 - s3.head<4>()).norm(), 1e-14 * rubber.E);
    EXPECT_GT(std::abs(s2[2]), 1e3);
}

TEST(NeoHookeanLaw, insideOutIsAFailedStep) {
    Tensor<2> F;
    F << 0, 1, 1, 0;
    EXPECT_THROW(neoHookeanStress<2>(rubber, F), StepFailure);
}

}  // namespace
