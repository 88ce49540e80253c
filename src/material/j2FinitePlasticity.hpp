#pragma once
// Elastic-plastic solid at finite strain: F = F_e F_p, von Mises, isotropic hardening, Hencky's elasticity: W_s = mu
// e':e', U = kappa/2 (ln J)^2 with e the logarithmic elastic strain. Plastic flow keeps the volume.

#include "base/spectrum.hpp"
#include "material/hyperelasticLaw.hpp"
#include "material/j2Law.hpp"

namespace pfem {

class J2FinitePlasticity : public J2Law<HyperelasticLaw, J2FinitePlasticity> {
public:
    /// The equivalent plastic strain, and G = (F_p^T F_p)^-1, at first I.
    std::vector<std::string> historyNames() const override {
        return {"plasticStrain", "plasticGxx", "plasticGyy", "plasticGzz", "plasticGxy", "plasticGyz", "plasticGxz"};
    }
    std::vector<double> historyAtStart() const override { return {0, 1, 1, 1, 0, 0, 0}; }

    /// Elastic trial b_e = F G F^T; the deviator of its logarithmic strain is shortened to the yield stress (Simo
    /// 1992).
    Tensor<3> shear(const Tensor<3>& F, const RateStep& step) const {
        const double mu = elastic.mu();
        const auto trial = spectrum<3>(F * plasticMetric(step.before) * F.transpose());
        if (!(trial.values[0] > 0)) throw StepFailure("elastic strain of a plastic solid without bound");
        Vec<3> e = 0.5 * trial.values.array().log();
        const double mean = e.mean();
        const Vec<3> deviator = e.array() - mean;
        const double q = 2 * mu * std::sqrt(1.5) * deviator.norm();
        const double x = hardening.plasticStrain(q, step.before[0], 3 * mu);
        const double kept = x > 0 ? 1 - 3 * mu * x / q : 1;
        if (x > 0) {
            e = (kept * deviator).array() + mean;
            const Tensor<3> Fi = F.inverse();
            const Tensor<3> b = trial.vectors * (2 * e.array()).exp().matrix().asDiagonal() * trial.vectors.transpose();
            setPlasticMetric(Fi * b * Fi.transpose(), step.history);
        } else {
            std::copy(step.before.begin(), step.before.end(), step.history.begin());
        }
        step.history[0] = step.before[0] + x;
        const Vec<3> tau = 2 * mu * kept * deviator;
        return trial.vectors * (tau / F.determinant()).asDiagonal() * trial.vectors.transpose();
    }
    double energy(const Tensor<3>& F, std::span<const double> history) const {
        const Vec<3> b = eigenvalues<3>(F * plasticMetric(history) * F.transpose());
        Vec<3> e = 0.5 * b.array().log();
        e.array() -= e.mean();
        return elastic.mu() * e.squaredNorm();
    }
    double volumePressure(double J) const override {
        if (!(J > 0)) throw StepFailure("solid without volume: ratio of volumes <= 0");
        return -elastic.kappa() * std::log(J) / J;
    }
    double volumeEnergy(double J) const override { return 0.5 * elastic.kappa() * std::log(J) * std::log(J); }

private:
    static Tensor<3> plasticMetric(std::span<const double> h) {
        Tensor<3> G;
        G << h[1], h[4], h[6], h[4], h[2], h[5], h[6], h[5], h[3];
        return G;
    }
    static void setPlasticMetric(const Tensor<3>& G, std::span<double> h) {
        h[1] = G(0, 0);
        h[2] = G(1, 1);
        h[3] = G(2, 2);
        h[4] = 0.5 * (G(0, 1) + G(1, 0));
        h[5] = 0.5 * (G(1, 2) + G(2, 1));
        h[6] = 0.5 * (G(0, 2) + G(2, 0));
    }
};

}  // namespace pfem
