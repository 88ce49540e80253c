#pragma once
// Energies of a state and the powers that change them.

#include "conditions/problem.hpp"
#include "solver/controls.hpp"
#include "solver/fluidEnergy.hpp"

namespace pfem {

/// [W/m (2D), W]
struct EnergyPowers {
    double viscous = 0, damper = 0, walls = 0, drive = 0;
};

/// Elastic energy of the solids: sum_p Omega_p sigma : C^-1 : sigma / 2 (exact for small strain); neoHookean:
/// sum_p Omega_p W(F_p).
template <int Dim>
double elasticEnergy(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state);

/// fluidEnergy() and that of the solids.
template <int Dim>
StoredEnergy storedEnergy(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state);

/// Dissipation sum_e |e| s_e : grad v by viscosity (and friction at walls) and by the zig-zag damper, power of walls
/// and clamps that move, and of the force that holds a flow through periodic sides.
template <int Dim>
EnergyPowers energyPowers(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state);

}  // namespace pfem
