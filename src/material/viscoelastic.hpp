#pragma once
// Rubber with damping: a nearly incompressible neo-Hookean solid and beside it Maxwell's branches, springs with the
// `ratios` beta_k of its shear modulus in series with dashpots of the relaxation times tau_k (Simo 1987, Holzapfel
// 1996):
//     S = S_iso + sum_k Q_k,   dQ_k/dt + Q_k/tau_k = beta_k dS_iso/dt.
// Branches that are slow beside the motion make it stiffer; fast ones damp it as Kelvin and Voigt's dashpot of the
// viscosity beta tau mu does.

#include <algorithm>
#include <array>

#include "material/decoupledLaw.hpp"

namespace pfem {

class Viscoelastic : public HyperelasticLaw<Viscoelastic> {
public:
    IsotropicElasticity elastic;  // what remains when all branches have relaxed
    std::vector<double> ratios, times;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("E", elastic.E, "Pa", "Young's modulus when all branches have relaxed", positive);
        v.required("nu", elastic.nu, "-", "Poisson's ratio then", poissonsRatio);
        v.required("ratios", ratios, "-", "of the branches: their shear modulus / that of E and nu", positive);
        v.required("times", times, "s", "of the branches: their relaxation times, as many", positive);
    }
    std::string fault() const {
        return ratios.size() == times.size() ? "" : "'ratios' and 'times' must have equally many numbers";
    }
    /// With all branches unrelaxed.
    IsotropicElasticity elasticity() const override {
        double sum = 1;
        for (const double ratio : ratios) sum += ratio;
        return elasticityOf(sum * elastic.mu(), elastic.kappa());
    }
    /// S_iso at the last step, and Q of each branch: xx yy zz xy yz xz.
    std::vector<std::string> historyNames() const override {
        std::vector<std::string> names;
        for (std::size_t k = 0; k <= ratios.size(); ++k)
            for (const char* component : {"xx", "yy", "zz", "xy", "yz", "xz"})
                names.push_back((k == 0 ? "elasticS" : "branch" + std::to_string(k)) + component);
        return names;
    }

    Tensor<3> shear(const Tensor<3>& F, const RateStep& step) const {
        const Tensor<3> S = elasticStress(F), change = S - tensorOf(step.before, 0);
        setTensor(S, step.history, 0);
        Tensor<3> sum = S;
        for (std::size_t k = 0; k < ratios.size(); ++k) {
            const double x = step.dt / times[k];
            const double grown = x > 0 ? -std::expm1(-x) / x : 1;  // of a branch that is strained evenly during dt
            const Tensor<3> Q = std::exp(-x) * tensorOf(step.before, k + 1) + ratios[k] * grown * change;
            setTensor(Q, step.history, k + 1);
            sum += Q;
        }
        const Tensor<3> sigma = F * sum * F.transpose() / F.determinant();
        return sigma - sigma.trace() / 3 * Tensor<3>::Identity();
    }
    /// Of all springs (of the branches as at small strain).
    double energy(const Tensor<3>& F, std::span<const double> history) const {
        double sum = 0.5 * elastic.mu() * (Isochoric(F).I1 - 3);
        for (std::size_t k = 0; k < ratios.size() && !history.empty(); ++k)
            sum += tensorOf(history, k + 1).squaredNorm() / (4 * ratios[k] * elastic.mu());
        return sum;
    }
    double volumePressure(double J) const override {
        if (!(J > 0)) throw StepFailure("solid without volume: ratio of volumes <= 0");
        return -0.5 * elastic.kappa() * (J - 1 / J);
    }
    double volumeEnergy(double J) const override { return 0.25 * elastic.kappa() * (J * J - 1 - 2 * std::log(J)); }

private:
    /// S_iso = mu J^(-2/3) (I - tr C/3 C^-1).
    Tensor<3> elasticStress(const Tensor<3>& F) const {
        const Tensor<3> C = F.transpose() * F;
        return elastic.mu() * std::pow(F.determinant(), -2.0 / 3) *
               (Tensor<3>::Identity() - C.trace() / 3 * C.inverse());
    }
    static Tensor<3> tensorOf(std::span<const double> h, std::size_t k) {
        const auto t = h.subspan(6 * k, 6);
        Tensor<3> full;
        full << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
        return full;
    }
    static void setTensor(const Tensor<3>& t, std::span<double> h, std::size_t k) {
        const std::array<double, 6> values{t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
        std::copy(values.begin(), values.end(), h.begin() + static_cast<std::ptrdiff_t>(6 * k));
    }
};

}  // namespace pfem
