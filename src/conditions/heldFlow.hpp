#pragma once
// The flow that a body force holds through periodic sides: entries of constant/periodic.
//
//     x         (0 2);
//     flowRate  (0.1 0 0);

#include "dictionary/function1.hpp"
#include "state/images.hpp"

namespace pfem {

/// Over time: volume through the sides, the mean over all sections between them [m2/s (2D), m3/s], or the mean velocity
/// of the fluid [m/s].
struct HeldFlow {
    Function1Ptr<Eigen::Vector3d> value;
    bool ofVolume = false;  // flowRate
    Location where;         // of the dictionary

    /// int v dV of so much fluid at time t; zero in directions without sides, where nothing is held. Throws UserError
    /// for a flow along one of these.
    template <int Dim>
    Vec<Dim> integral(const Period<Dim>& period, double volume, double t) const {
        const Vec<Dim> flow = value->value(t).template head<Dim>();
        for (int k = 0; k < Dim; ++k)
            if (period.length[k] == 0 && flow[k] != 0)
                throw UserError(std::string("the flow is held between periodic sides, and there are none in ") +
                                    "xyz"[k] + ": the component must be 0",
                                where);
        const Vec<Dim> length = ofVolume ? period.length : Vec<Dim>::Constant(volume);
        return (period.length.array() > 0).select(flow.cwiseProduct(length), Vec<Dim>::Zero());
    }
};

/// `flowRate` or `meanVelocity`; null: neither. Throws UserError for both, and for a flow along a direction without
/// sides.
template <int Dim>
std::shared_ptr<const HeldFlow> heldFlowOf(const Dictionary& dict, const Period<Dim>& period) {
    if (dict.found("flowRate") && dict.found("meanVelocity"))
        dict.fatal("meanVelocity", "Give either flowRate or meanVelocity, not both");
    const bool ofVolume = dict.found("flowRate");
    const std::string key = ofVolume ? "flowRate" : "meanVelocity";
    if (!dict.found(key)) return nullptr;
    auto flow = std::make_shared<HeldFlow>();
    flow->ofVolume = ofVolume;
    flow->value = Dim == 2 ? readPlaneFunction1(dict, key) : readFunction1<Eigen::Vector3d>(dict, key);
    flow->where = dict.where();
    if (flow->value->isConstant()) flow->integral<Dim>(period, 0, 0);  // others are looked at as time goes on
    return flow;
}

}  // namespace pfem
