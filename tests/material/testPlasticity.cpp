// J2 plasticity against closed forms at one point.

#include <gtest/gtest.h>

#include "lawSamples.hpp"
#include "material/hardening.hpp"

using namespace pfem;
using namespace pfem::test;

namespace {

/// A bar that is stretched with free sides.
class Bar {
public:
    Bar(const std::string& type, const std::string& entries) : point_(type, entries) {}

    /// Cauchy stress after stretching by the factor exp(strain) from the present length.
    double stretch(double strain) {
        const double axial = axial_ * std::exp(strain);
        double lateral = lateral_;
        for (int n = 0; n < 50; ++n) {  // Newton for the sides' stress
            const double eps = 1e-7, r = sides(axial, lateral);
            const double change = -r * eps / (sides(axial, lateral + eps) - r);
            lateral += change;
            if (std::abs(change) < 1e-14) break;
        }
        const double stress = point_.go(gradient(axial_, lateral_), gradient(axial, lateral))[0];
        axial_ = axial;
        lateral_ = lateral;
        return stress;
    }
    double stretchBy(double strain, int steps) {
        double stress = 0;
        for (int k = 0; k < steps; ++k) stress = stretch(strain / steps);
        return stress;
    }
    double volume() const { return axial_ * lateral_ * lateral_; }
    double plasticStrain() const { return point_.history[0]; }

private:
    static Tensor<3> gradient(double axial, double lateral) { return Vec<3>(axial, lateral, lateral).asDiagonal(); }
    double sides(double axial, double lateral) const {
        LawAtPoint<3> trial = point_;
        return trial.go(gradient(axial_, lateral_), gradient(axial, lateral))[1];
    }
    LawAtPoint<3> point_;
    double axial_ = 1, lateral_ = 1;
};

constexpr double E = 2e5;

// Linear hardening: sigma = sigma_y + E H/(E + H) (e - sigma_y/E), back with E, and yielding again at - sigma_y(a).
TEST(J2Plasticity, barWithLinearHardening) {
    const double H = 2e4, y = 400;
    Bar bar("j2Plasticity", "E 2e5; nu 0.3; yieldStress 400; hardening 2e4;");
    EXPECT_NEAR(bar.stretchBy(0.9 * y / E, 3), 0.9 * y, 1e-3 * y);
    EXPECT_EQ(bar.plasticStrain(), 0);
    const double strain = 0.02, stress = y + E * H / (E + H) * (strain - y / E);
    EXPECT_NEAR(bar.stretchBy(strain - 0.9 * y / E, 200), stress, 1e-4 * stress);
    EXPECT_NEAR(bar.plasticStrain(), strain - stress / E, 1e-4 * strain);
    EXPECT_NEAR(bar.stretchBy(-stress / E, 10), 0, 2e-4 * stress);
    EXPECT_NEAR(bar.stretchBy(-0.02, 200), -(stress + E * H / (E + H) * (0.02 - stress / E)), 1e-3 * stress);
}

// At finite strain sigma J = sigma_y(a), a = ln l - sigma J/E: exact for Hencky's elasticity, however long the steps.
TEST(J2FinitePlasticity, barWithVoceHardening) {
    const Hardening hardening{400, 500, 700, 20};
    for (const int steps : {1, 7}) {
        Bar bar("j2FinitePlasticity",
                "E 2e5; nu 0.499; yieldStress 400; hardening 500; saturationStress 700; saturationRate 20;");
        const double strain = 0.8, stress = bar.stretchBy(strain, steps) * bar.volume();
        const double a = bar.plasticStrain();
        EXPECT_NEAR(stress, hardening.stress(a), 1e-8 * stress);
        EXPECT_NEAR(a, strain - stress / E, 1e-8);
        EXPECT_GT(stress, 1000);
    }
}

// Both laws are one at small strain, along a path that bends.
TEST(J2FinitePlasticity, smallStrainIsTheLawInRates) {
    const std::string entries =
        "E 2e5; nu 0.3; yieldStress 40; hardening 2e4; saturationStress 70; saturationRate 1e3;";
    LawAtPoint<3> rates("j2Plasticity", entries), finite("j2FinitePlasticity", entries);
    Tensor<3> F = Tensor<3>::Identity();
    const int steps = 100;
    Stress<3> a, b;
    for (int k = 0; k < steps; ++k) {
        Tensor<3> change = Tensor<3>::Zero();
        change(0, 1) = 1e-3 / steps * std::cos(3.0 * k / steps);
        change(1, 1) = 5e-4 / steps;
        change(2, 0) = 8e-4 / steps * std::sin(2.0 * k / steps);
        a = rates.go(F, F + change);
        b = finite.go(F, F + change);
        F += change;
    }
    EXPECT_GT(rates.history[0], 2e-4);
    EXPECT_NEAR(rates.history[0], finite.history[0], 2e-3 * rates.history[0]);
    EXPECT_LT((a - b).norm(), 5e-3 * a.norm());
}

// The stress of a point that has yielded does not change when nothing moves (the balance of forces asks for it again).
TEST(J2FinitePlasticity, asksTwiceIsAnsweredTwice) {
    LawAtPoint<3> point("j2FinitePlasticity", solidSamples.at("j2FinitePlasticity"));
    Tensor<3> F = Tensor<3>::Identity();
    F(0, 1) = 0.5;
    const Stress<3> first = point.go(Tensor<3>::Identity(), F);
    EXPECT_GT(point.history[0], 0.2);
    const double energy = point.law->shearEnergy(F, point.history);
    const Stress<3> second = point.go(F, F);
    EXPECT_LT((first - second).norm(), 1e-9 * first.norm());
    EXPECT_NEAR(point.law->shearEnergy(F, point.history), energy, 1e-9 * energy);
}

TEST(Hardening, voce) {
    const Hardening h{1e3, 1e4, 2e3, 50};
    EXPECT_EQ(h.stress(0), 1e3);
    EXPECT_NEAR(h.stress(10), 2e3 + 1e5, 1e-9);
    for (const double a : {0.0, 0.01, 0.1})
        EXPECT_NEAR(h.slope(a), (h.stress(a + 1e-6) - h.stress(a - 1e-6)) / 2e-6, 1e-3);
    const double x = h.plasticStrain(5e3, 0.01, 3e5);
    EXPECT_NEAR(5e3 - 3e5 * x, h.stress(0.01 + x), 1e-8);
}

}  // namespace
