#pragma once
// Elastic-plastic solid (von Mises, isotropic hardening) in rates: small elastic strains, any rotation.

#include "material/j2Law.hpp"
#include "material/rateLaw.hpp"

namespace pfem {

class J2Plasticity : public J2Law<RateLaw, J2Plasticity> {
public:
    std::vector<std::string> historyNames() const override { return {"plasticStrain"}; }

    /// Radial return: the deviator of the elastic trial is shortened to the yield stress at the step's end.
    Tensor<3> updated(const Tensor<3>& sigma, const Tensor<3>& strain, const RateStep& step) const {
        const Tensor<3> I = Tensor<3>::Identity();
        const double mu = elastic.mu();
        const Tensor<3> trial = sigma + elastic.lambda() * strain.trace() * I + 2 * mu * strain;
        const Tensor<3> s = trial - trial.trace() / 3 * I;
        const double q = std::sqrt(1.5) * s.norm(), x = hardening.plasticStrain(q, step.before[0], 3 * mu);
        step.history[0] = step.before[0] + x;
        return x > 0 ? Tensor<3>(trial - 3 * mu * x / q * s) : trial;
    }
};

}  // namespace pfem
