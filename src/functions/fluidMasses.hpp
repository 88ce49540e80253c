#pragma once
// The fluid's mass as functions count it.

#include "material/material.hpp"
#include "momentum/mass.hpp"
#include "state/images.hpp"

namespace pfem {

/// Lumped masses of the fluid's cells, each counted once [kg/m (2D), kg].
template <int Dim>
PerNode<double> massOfCells(const Problem<Dim>& problem, const State<Dim>& state) {
    auto own = state.mesh.fluid;
    own.nodes.resize(nOwnCells<Dim>(state));
    return fluidMass<Dim>(problem, own, state.nodes.x);
}

/// `mass` with that of drops.
template <int Dim>
PerNode<double> withDrops(const Problem<Dim>& problem, const State<Dim>& state, PerNode<double> mass) {
    const ViscousFluid* first = firstFluid(problem.materials);
    if (!first) return mass;
    for (int i = 0; i < nOwnNodes<Dim>(state); ++i) mass[i] += first->rho * state.nodes.dropVolume[i];
    return mass;
}

}  // namespace pfem
