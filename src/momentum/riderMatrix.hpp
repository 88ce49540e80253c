#pragma once
// The mass of fluid that rides on solids, in their matrix: what they push along in the normal direction.

#include "momentum/solidMatrix.hpp"

namespace pfem {

/// Velocity of a node for a change of the solids' unknowns.
template <int Dim>
struct SolidVelocity {
    int unknown;
    Vec<Dim> velocity;
};

/// Of a rider: dual (normal . u) by the unknowns of the nodes under it, each once, ascending.
template <int Dim>
std::vector<SolidVelocity<Dim>> carriedBy(const SolidDofs<Dim>& dofs, const Rider<Dim>& rider);

/// Add sum over the riders of m |dual|^2 (W^T normal) (W^T normal)^T, W: the solid's velocity under the rider by its
/// unknowns, m: the rider's inertia along the normal.
template <int Dim>
void addRiders(const std::vector<Rider<Dim>>& riders, const Points<Dim>& inertia, SolidBlock<Dim>& block);

}  // namespace pfem
