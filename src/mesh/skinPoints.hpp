#pragma once
// Where a face of the fluid lies on faces of a solid that are not its own: points of integration over both.

#include "mesh/topology.hpp"

namespace pfem {

/// A point of a face of the fluid and the same of the solid.
template <int Dim>
struct SkinPoint {
    double part;       // of the face's measure; they add up to 1
    Vec<Dim> onFluid;  // weights of the nodes of the fluid's face
    Ride<Dim> onSolid;
};

/// Of a face of the fluid on a skin; x: of all nodes. In the plane two on each piece that lies on one face of the
/// solid: exact for products of linear functions. In space three in each quarter, wherever the solid's edges run: exact
/// for quadratic functions of the fluid's face. Empty where a node of the face does not ride.
template <int Dim>
std::vector<SkinPoint<Dim>> skinPoints(const Topology<Dim>& topology, const Points<Dim>& x, const FluidFace<Dim>& face);

}  // namespace pfem
