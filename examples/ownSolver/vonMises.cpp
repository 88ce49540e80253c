// `type vonMises`: elastic-perfectly plastic solid, as a material of one's own in one file.
//
//     clay { type vonMises; rho 1800; E 1e6; nu 0.3; yieldStress 2e3; }
//
// Radial return: the elastic trial stress sigma + C : strain; where its von Mises stress q = sqrt(3/2 s : s) is above
// the yield stress, its deviator s is shortened to it.

#include <cmath>

#include "dictionary/entries.hpp"
#include "material/material.hpp"

using namespace pfem;

namespace {

struct VonMisesEntries {
    double yieldStress = 0;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("yieldStress", yieldStress, "Pa", "von Mises stress at which the solid yields", positive);
    }
};

class VonMises : public SolidLaw {
public:
    VonMises(const Dictionary& dict, const Hypoelastic& elastic)
        : lambda_(elastic.lambda()), mu_(elastic.mu()), yieldStress_(readEntries<VonMisesEntries>(dict).yieldStress) {}

    Tensor<3> updated(const Tensor<3>& sigma, const Tensor<3>& strain) const override {
        const Tensor<3> I = Tensor<3>::Identity();
        const Tensor<3> trial = sigma + lambda_ * strain.trace() * I + 2 * mu_ * strain;
        const Tensor<3> s = trial - trial.trace() / 3 * I;
        const double q = std::sqrt(1.5) * s.norm();
        if (q <= yieldStress_) return trial;
        return trial - (1 - yieldStress_ / q) * s;
    }

private:
    double lambda_, mu_, yieldStress_;
};

const bool added = addSolidLaw("vonMises", [](const Dictionary& dict, const Hypoelastic& elastic) {
    return std::unique_ptr<SolidLaw>(new VonMises(dict, elastic));
});

}  // namespace
