#pragma once
// Drops that come so near to a node of the fluid that there is no place for two.

#include "remesh/controls.hpp"
#include "remesh/movedMesh.hpp"
#include "state/state.hpp"

namespace pfem {

/// Drops that approach a node in cells and are nearer than removeDistanceFilm h to it join it: they are to be
/// removed, their momentum goes to the node at once, by the volumes of patch and drop, what they carry is
/// handed over with the node as heir (MovedMesh::joins). As nodes of their own they would make triangles that
/// no step can hold.
template <int Dim>
void joinDrops(const RemeshingControls& controls, MovedMesh<Dim>& moved, State<Dim>& state);

}  // namespace pfem
