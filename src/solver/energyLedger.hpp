#pragma once
// Energy that comes and goes with the fluid's volume and connectivity, as the equations of motion do not know it.

#include "mesh/topology.hpp"
#include "state/problem.hpp"

namespace pfem {

/// Kinetic and potential energy of the fluid with its lumped mass, of drops, and int p^2/(2 kappa) [J/m (2D), J].
template <int Dim>
double fluidEnergy(const Problem<Dim>& problem, const State<Dim>& state);

/// What a step's change of volume has brought in with one connectivity, from `old` to `now` [J/m (2D), J]:
/// sum_I rho (v^2/2 - g . x) dOmega_I, mean of both, and the work p_I `returned`_I against the pressure.
template <int Dim>
double volumeEnergy(const Problem<Dim>& problem, const Cells<Dim>& cells, const Nodes<Dim>& old, const Nodes<Dim>& now,
                    const std::vector<double>& returned);

}  // namespace pfem
