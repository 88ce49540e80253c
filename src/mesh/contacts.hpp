#pragma once
// The same mesh where solids meet walls.

#include "mesh/topology.hpp"

namespace pfem {

/// A gap between solids and walls in which there is no fluid, in parts of h: triangles across it would be as flat.
constexpr double nearContact = 0.05;

/// Solids' nodes that are nearer to walls than that touch them: the walls' faces of the fluid go on from there.
template <int Dim>
Topology<Dim> withContacts(const Mesh<Dim>& mesh, const std::vector<PatchKind>& kinds, const Points<Dim>& x,
                           const std::vector<Supports<Dim>>& wall, Topology<Dim> topology);

}  // namespace pfem
