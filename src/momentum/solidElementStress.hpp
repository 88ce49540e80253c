#pragma once
// Element stress of solids, whose force is that of their stress points, and the zig-zag damper.

#include "momentum/solidStress.hpp"

namespace pfem {

/// Element stress that makes the nodal force from the points' stress (fromPoints) and the pressure, plus the damper's
/// tau_s C : (d_e - fromPoints(d)_e), which vanishes for linear velocity fields and for elemental integration.
///   domains: updateGradientDomains;  end: at trial.x
template <int Dim>
PerCell<Tensor<Dim>> solidElementStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains,
                                        const SmoothingDomains<Dim>& end, const SolidStress<Dim>& stress,
                                        const Nodes<Dim>& trial);

/// The same for a state as it is stored, with the domains at its positions.
template <int Dim>
PerCell<Tensor<Dim>> storedElementStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains,
                                         const Nodes<Dim>& nodes);

/// Store the accepted stress at nodes and, elemental, in cells: sigma = s - p I; see storeFromPoints.
template <int Dim>
void storeSolidStress(const SmoothingDomains<Dim>& domains, SolidStress<Dim> stress, PerNode<Stress<Dim>>& nodal,
                      std::vector<Stress<Dim>>& cell);

/// tau_s = alpha h sqrt(rho/E) [s].
double dampingTime(const Solid& material, double alpha, double h);

}  // namespace pfem
