#pragma once
// Where a remeshing has changed the volume of the fluid, without contacts and what was let go.

#include "remesh/connectivity.hpp"
#include "remesh/movedMesh.hpp"

namespace pfem {

/// Old cells that have gone and the new ones in their place, joined by their faces.
template <int Dim>
struct Cavity {
    std::vector<int> nodes;  // of its cells, those that are left; ascending
    double gain = 0;         // measure of the new cells less that of the old ones: none but at the surface [m2 (2D), m3]
};

/// The cavities between the moved old mesh and the new cells. `newIndex`: of the old nodes, -1: gone; `selected`: with
/// masters in the place of images.
template <int Dim>
std::vector<Cavity<Dim>> cavities(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex,
                                  const CellChanges<Dim>& selected);

}  // namespace pfem
