#pragma once
// What the solver asks of the law of a fluid: its viscosity. A law is one class with its entries and its formula:
//
//     class MyFluid : public FluidLawOf<MyFluid> {
//     public:
//         double mu0 = 0;
//         template <class Visitor>
//         void entries(Visitor& v) {
//             v.required("mu0", mu0, "Pa s", "viscosity at rest", positive);
//         }
//         double viscosity(double g, double) const override { return mu0 / (1 + g); }
//         double slope(double g, double) const override { return -mu0 / ((1 + g) * (1 + g)); }
//     };
//
// and a line in lawTable.cpp or, in a project of one's own, addFluidLaw (lawTable.hpp).

#include <span>

#include "base/types.hpp"

namespace pfem {

/// Stress points of one fluid, one after the other: what a law is asked for in one call.
struct FlowPoints {
    std::span<const double> rate;      // g = sqrt(2 d':d') [1/s]
    std::span<const double> pressure;  // [Pa]
    std::span<double> mu;              // out: viscosity [Pa s]
    std::span<double> slope;           // out: d mu/d g [Pa s2]; empty: not asked for
};

/// Generalised Newtonian fluid: s = 2 mu(g, p) d', d' the deviator of the strain rate, g = sqrt(2 d':d').
class FluidLaw {
public:
    virtual ~FluidLaw() = default;

    /// mu [Pa s] at the shear rate g [1/s] and the pressure p [Pa], and d mu/d g [Pa s2].
    virtual double viscosity(double g, double p) const = 0;
    virtual double slope(double g, double p) const = 0;

    /// false: mu is one number, and no shear rate has to be found.
    virtual bool dependsOnFlow() const { return true; }

    /// Both for many points.
    virtual void evaluate(const FlowPoints& points) const = 0;
};

template <class Law>
class FluidLawOf : public FluidLaw {
public:
    void evaluate(const FlowPoints& points) const final {
        const Law& law = static_cast<const Law&>(*this);
        for (std::size_t p = 0; p < points.rate.size(); ++p)
            points.mu[p] = law.Law::viscosity(points.rate[p], points.pressure[p]);
        for (std::size_t p = 0; p < points.slope.size(); ++p)
            points.slope[p] = law.Law::slope(points.rate[p], points.pressure[p]);
    }
};

}  // namespace pfem
