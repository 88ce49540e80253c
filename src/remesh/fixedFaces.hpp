#pragma once
// Faces that a triangulation must have.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Faces of solids and symmetry planes, and between nodes that follow each other along a wall: no fluid triangle may
/// cross them. Over bends, only nodes nearer than 3 h are joined: between others there may be air.
/// `topology`: before nodes came and went; `newIndex`: of its nodes, -1 gone. None in 3D, where nothing constrains.
template <int Dim>
std::vector<Face<Dim>> fixedFaces(const State<Dim>& state, const std::vector<PatchKind>& kinds,
                                  const Topology<Dim>& topology, const std::vector<int>& newIndex);

}  // namespace pfem
