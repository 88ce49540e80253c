#pragma once
// Drops that become part of a node of the fluid: where there is no place for two, and where there is no room any more.

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

/// Drops among `pinched` are squeezed out from between surfaces that close: what they carry goes to the nearest node in
/// cells that no wall and no solid holds and that is not pinched itself. Returns those that find none; they are let go
/// (MovedMesh::gone). Their momentum stays with what closes on them.
template <int Dim>
std::vector<int> squeezeDrops(const std::vector<int>& pinched, MovedMesh<Dim>& moved);

}  // namespace pfem
