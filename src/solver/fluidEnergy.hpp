#pragma once
// Energy that comes and goes with the fluid's volume and connectivity, as the equations of motion do not know it.

#include "conditions/problem.hpp"
#include "mesh/topology.hpp"
#include "momentum/controls.hpp"

namespace pfem {

/// [J/m (2D), J]
struct StoredEnergy {
    double kinetic = 0;    // sum m v^2/2
    double elastic = 0;    // of the solids, and int p^2/(2 kappa) of the fluid
    double potential = 0;  // - sum m g . x
    double total() const { return kinetic + elastic + potential; }
    StoredEnergy& operator+=(const StoredEnergy& other) {
        kinetic += other.kinetic;
        elastic += other.elastic;
        potential += other.potential;
        return *this;
    }
};

/// Of the fluid, with lumped mass sum_e |e|/(d+1) sum_I ..., and of drops, which are of the first fluid.
template <int Dim>
StoredEnergy fluidEnergy(const Problem<Dim>& problem, const State<Dim>& state, FluidMass mass = FluidMass::lumped);

/// What a step's change of volume has brought in with one connectivity, from `old` to `now` [J/m (2D), J]:
/// sum_I rho (v^2/2 - g . x) dOmega_I, mean of both (with consistent mass the cells' v^2), and the work p_I
/// `returned`_I against the pressure.
template <int Dim>
double volumeEnergy(const Problem<Dim>& problem, const Cells<Dim>& cells, const Nodes<Dim>& old, const Nodes<Dim>& now,
                    const std::vector<double>& returned, FluidMass mass = FluidMass::lumped);

}  // namespace pfem
