// `type vonMises`: elastic-perfectly plastic solid, as a material of one's own in one file.
//
//     clay { type vonMises; rho 1800; E 1e6; nu 0.3; yieldStress 2e3; }
//
// Radial return: the elastic trial stress sigma + C : strain; where its von Mises stress q = sqrt(3/2 s : s) is above
// the yield stress, its deviator s is shortened to it.

#include <cmath>

#include "material/lawTable.hpp"
#include "material/rateLaw.hpp"

using namespace pfem;

namespace {

class VonMises : public RateLaw<VonMises> {
public:
    IsotropicElasticity elastic;
    double yieldStress = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        elastic.entries(v);
        v.required("yieldStress", yieldStress, "Pa", "von Mises stress at which the solid yields", positive);
    }
    IsotropicElasticity elasticity() const override { return elastic; }

    Tensor<3> updated(const Tensor<3>& sigma, const Tensor<3>& strain) const {
        const Tensor<3> I = Tensor<3>::Identity();
        const Tensor<3> trial = sigma + elastic.lambda() * strain.trace() * I + 2 * elastic.mu() * strain;
        const Tensor<3> s = trial - trial.trace() / 3 * I;
        const double q = std::sqrt(1.5) * s.norm();
        if (q <= yieldStress) return trial;
        return trial - (1 - yieldStress / q) * s;
    }
};

const bool added = addSolidLaw<VonMises>("vonMises", "Elastic-perfectly plastic solid.");

}  // namespace
