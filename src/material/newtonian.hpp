#pragma once
// Newtonian fluid: one viscosity.

#include <memory>

#include "dictionary/range.hpp"
#include "material/fluidLaw.hpp"

namespace pfem {

/// The law `newtonian`.
class Newtonian : public FluidLawOf<Newtonian> {
public:
    double mu = 1e-3;  // [Pa s]

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("mu", mu, "Pa s", "dynamic viscosity", nonNegative);
    }
    double viscosity(double, double) const override { return mu; }
    double slope(double, double) const override { return 0; }
    bool dependsOnFlow() const override { return false; }
};

inline std::shared_ptr<const FluidLaw> newtonian(double mu) {
    auto law = std::make_shared<Newtonian>();
    law->mu = mu;
    return law;
}

}  // namespace pfem
