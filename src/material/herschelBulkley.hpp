#pragma once
// Fluids with a yield stress: Herschel and Bulkley's law and Bingham's.

#include <memory>

#include "dictionary/range.hpp"
#include "material/fluidLaw.hpp"

namespace pfem {

/// mu(g) = tau0 (1 - exp(-m g)) / g + k g^(n-1) [Pa s]: Herschel and Bulkley's law with Papanastasiou's regularisation,
/// under which a fluid at rest creeps with the viscosity m tau0. n != 1: g of the second term is sqrt(g^2 + 1/m^2).
struct YieldingFlow {
    double k = 0;     // consistency [Pa s^n]
    double n = 1;     // flow index [-]
    double tau0 = 0;  // yield stress [Pa]
    double m = 1000;  // Papanastasiou's time [s]

    double viscosity(double g) const;
    double slope(double g) const;
    bool dependsOnFlow() const { return tau0 != 0 || n != 1; }

    template <class Visitor>
    void yieldEntries(Visitor& v) {
        v.required("tau0", tau0, "Pa", "yield stress; 0: none", nonNegative);
        v("m", m, "s", "Papanastasiou's time: shear rates below 1/m creep with the viscosity m tau0", positive);
    }
};

/// The law `herschelBulkley`.
class HerschelBulkley : public FluidLawOf<HerschelBulkley> {
public:
    YieldingFlow flow;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("n", flow.n, "-", "flow index: below 1 shear thinning, above 1 thickening", positive);
        v.required("k", flow.k, "Pa s^n", "consistency", positive);
        flow.yieldEntries(v);
    }
    double viscosity(double g, double) const override { return flow.viscosity(g); }
    double slope(double g, double) const override { return flow.slope(g); }
    bool dependsOnFlow() const override { return flow.dependsOnFlow(); }
};

/// The law `bingham`: n = 1.
class Bingham : public FluidLawOf<Bingham> {
public:
    YieldingFlow flow;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("mu", flow.k, "Pa s", "plastic viscosity", nonNegative);
        flow.yieldEntries(v);
    }
    double viscosity(double g, double) const override { return flow.viscosity(g); }
    double slope(double g, double) const override { return flow.slope(g); }
    bool dependsOnFlow() const override { return flow.dependsOnFlow(); }
};

inline std::shared_ptr<const FluidLaw> herschelBulkley(const YieldingFlow& flow) {
    auto law = std::make_shared<HerschelBulkley>();
    law->flow = flow;
    return law;
}

}  // namespace pfem
