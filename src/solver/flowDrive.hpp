#pragma once
// The body force that holds the flow through periodic sides: a Lagrange multiplier of the step.

#include "solver/momentumEquation.hpp"

namespace pfem {

/// The acceleration lambda of the fluid, along the directions with sides, with which
///     sum_J Omega_J v_J = Problem::flow    at the end of the step,
/// Omega in the middle. In each iteration lambda and dv change by what the momentum equation answers to it,
///     dv += sum_k dlambda_k s_k,    (M/(gamma dt) + K) s_k = m e_k/gamma;    pressure comes after, as for all of dv.
/// s_k knows nothing of contacts of solids: these hold in the limit, where dlambda is zero.
template <int Dim>
class FlowDrive {
public:
    /// Without a flow to hold it does nothing. The references must outlive it.
    FlowDrive(const Step<Dim>& step, const FluidPhase<Dim>& fluid);

    /// Changes Trial::drive and dv so that v + dv has the flow.
    void hold(MomentumEquation<Dim>& momentum, Trial<Dim>& trial, Points<Dim>& dv);

private:
    /// sum_J Omega_J u_J of the nodes that are no images; `volumes`: Omega_J.
    Vec<Dim> integral(const std::vector<double>& volumes, const Points<Dim>& u) const;

    const Step<Dim>& step_;
    const FluidPhase<Dim>& fluid_;
    std::vector<int> directions_;       // with sides
    std::vector<Points<Dim>> answers_;  // s_k of each of them
};

}  // namespace pfem
