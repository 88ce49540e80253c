#pragma once
// Fluid that slides over solids goes along with them in the normal direction, and hands its normal force over.

#include <vector>

#include "mesh/ride.hpp"

namespace pfem {

/// A node of the fluid on one solid: of the solid's velocity u there it has the part dual (normal . u), beside what it
/// is free to do and what other walls prescribe.
template <int Dim>
struct Rider {
    Ride<Dim> ride;
    Vec<Dim> normal, dual;  // dual . normal = 1; dual . n = 0 for the normals of the other walls that hold the node

    Vec<Dim> carried(const Points<Dim>& u) const { return dual * normal.dot(ride.under(u)); }
    /// The same part of a velocity of the node itself.
    Vec<Dim> own(const Vec<Dim>& u) const { return dual * normal.dot(u); }
};

/// Velocities (or displacements) of the riders get what the solids under them have; `u`: of all nodes, of riders
/// without it.
template <int Dim>
void carryRiders(const std::vector<Rider<Dim>>& riders, Points<Dim>& u) {
    for (const auto& rider : riders) u[rider.ride.node] += rider.carried(u);
}

/// The adjoint: forces on riders in the directions in which the solids hold them are forces on the solids' nodes. Their
/// sum stays, and their moment when the nodes are on the faces.
template <int Dim>
void handOver(const std::vector<Rider<Dim>>& riders, Points<Dim>& force) {
    for (const auto& rider : riders) rider.ride.spread(rider.normal * rider.dual.dot(force[rider.ride.node]), force);
}

}  // namespace pfem
