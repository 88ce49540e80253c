#pragma once
// The fluid's mass as its linear velocities have it, beside the lumped one.

#include "momentum/fluidPhase.hpp"

namespace pfem {

/// y += factor (M - M_lumped) u of the fluid [factor kg (3D) times u's unit]:
///   M_IJ = sum_e rho |e| (1 + delta_IJ)/((d+1)(d+2)),   ((M - M_lumped) u)_I = sum_e rho |e|/((d+1)(d+2)) sum_J (u_J -
///   u_I)
/// zero for uniform u: what falls freely, or is moved as a whole, is the same with both.
template <int Dim>
void addMassDifference(const FluidPhase<Dim>& fluid, double factor, const Points<Dim>& u, Points<Dim>& y);

/// What v . (M - M_lumped) v of a cell is, over rho |e|/(d+1) [m2/s2].
template <int Dim>
double squaredSpeedDifference(const Simplex<Dim>& cell, const Points<Dim>& v);

}  // namespace pfem
