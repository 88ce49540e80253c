#pragma once
// Momentum residual (23)-(24).

#include "momentum/fluidPhase.hpp"
#include "momentum/solidPhase.hpp"

namespace pfem {

/// Mass of the solids (constant) plus that of the fluid in the configuration of its domains [kg/m (2D), kg].
template <int Dim>
std::vector<double> nodalMass(const FluidPhase<Dim>& fluid, const SolidPhase<Dim>& solid);

/// Consistent share of a traction patch: t |face|/d on each of its nodes [N/m (2D), N].
template <int Dim>
Points<Dim> tractionForce(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions, const Points<Dim>& x);

/// What the surroundings do to the nodes: tractions, bent walls, menisci, friction at walls and at the panes of a plane
/// flow [N/m (2D), N].
template <int Dim>
Points<Dim> externalForce(const Mesh<Dim>& mesh, const Topology<Dim>& topology, const FluidPhase<Dim>& fluid,
                          const Nodes<Dim>& nodes);

/// Nodal force of the viscous stress, that of `waveDamping` (zigzagForce) included [N/m (2D), N].
template <int Dim>
Points<Dim> viscousForces(const FluidPhase<Dim>& fluid, double waveDamping, const Nodes<Dim>& nodes);

/// R_J = m_J (a_J - g) - sum_e |e| p_e grad N_J (fluid) + share sum_e |e| sigma_e grad N_J (solid) - external, all
/// nodes [N/m (2D), N].
///   mass: nodalMass;  nodes: their a and p;  external: externalForce minus viscousForces
///   share: of the solids' present stress in the step's mean, 1 in the balance of a state
template <int Dim>
Points<Dim> momentumResidual(const std::vector<double>& mass, const Nodes<Dim>& nodes, const FluidPhase<Dim>& fluid,
                             const SolidPhase<Dim>& solid, const Points<Dim>& external, double share);

}  // namespace pfem
