#pragma once
// Viscous stress of the fluid (35), nodal or elemental as its domains say.

#include "conditions/problem.hpp"
#include "integration/stressPoints.hpp"

namespace pfem {

/// Does the viscosity of no fluid depend on the flow?
template <int Dim>
bool isNewtonian(const Problem<Dim>& problem);

/// The viscosity of every stress point and how it answers to the flow.
template <int Dim>
struct FlowViscosity {
    PerPoint<double> mu;         // [Pa s]; 0 outside the material
    PerPoint<Tensor<Dim>> rate;  // d' [1/s]; empty: no viscosity depends on the flow
    PerPoint<double> softening;  // (4/g) d mu/d g [Pa s3], g the shear rate
};

/// In the flow v with the nodal pressures p.
template <int Dim>
FlowViscosity<Dim> flowViscosity(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                 const SmoothingDomains<Dim>& domains, const Points<Dim>& v, const PerNode<double>& p);

/// mu + g d mu/d g of the points: what resists a change of the flow in its own direction [Pa s].
template <int Dim>
PerPoint<double> tangentViscosity(const FlowViscosity<Dim>& viscosity);

/// Nodal force of the points' viscous stress sigma = 2 mu d', d' = d - tr(d)/3 I, d of the velocity's gradients L
/// [N/m (2D), N].
template <int Dim>
Points<Dim> viscousForce(const SmoothingDomains<Dim>& domains, const PerPoint<double>& mu,
                         const VelocityGradients<Dim>& L);

/// Element stress with the force of the change of that stress with dv, plus `bulk` * tr(d) I per stress point (empty:
/// none): the operator of the momentum matrix (42)-(43). With a viscosity that depends on the flow: 2 mu dd' +
/// softening (d' : dd') d'.
template <int Dim>
PerCell<Tensor<Dim>> fluidTangentStress(const SmoothingDomains<Dim>& domains, const FlowViscosity<Dim>& viscosity,
                                        const Points<Dim>& dv, const PerPoint<double>& bulk);

/// Force of a viscosity mu_z = damping rho h sqrt(g h) that acts on velocities which alternate from node to node, and
/// on nothing else:
///     s_e = mu_z (D + D^T),   D = L_e less the mean of L_I over its nodes; `L`: the velocity's gradients.
/// Zero for linear velocities; it only takes energy. A wave of length l loses by some damping sqrt(g/h) (h/l)^4: short
/// ones die, long ones do not notice it.
template <int Dim>
Points<Dim> zigzagForce(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                        double damping, const PerNode<double>& h, const VelocityGradients<Dim>& L);

}  // namespace pfem
