#pragma once
// Removal of nodes that came too close and insertion where the mesh was stretched.

#include "remesh/controls.hpp"
#include "remesh/movedMesh.hpp"

namespace pfem {

/// Plan of one remeshing, in old node indices.
template <int Dim>
struct NodePlan {
    std::vector<unsigned char> removed;        // per old node
    std::vector<std::array<int, 2>> inserted;  // edges that get a node at their midpoint
    /// Free-surface faces after removal and insertion: old index i, or nOld + k for inserted node k.
    std::vector<Face<Dim>> surface;
    std::vector<std::array<int, 3>> cuts;  // (2D) removed surface nodes between their neighbours along the surface
};

constexpr unsigned char keptAtLip = 2;

/// Inner fluid nodes nearer than removeDistance h to a neighbour go (free-surface and wall nodes:
/// removeDistanceSurface, only when the neighbour is of the boundary, too; across a film: removeDistanceFilm); edges
/// longer than insertDistance h are halved. A node that slides into a corner of the walls where another one is held
/// goes, and an inner one lower than removeHeight h over a face of the free surface. At most one change per patch.
/// Nodes in corners of walls stay, and `kept` ones: 1 of solids and patches, between which no boundary edge is divided
/// either; keptAtLip: at the lip of an inlet. `pinched`: others that have to go.
template <int Dim>
NodePlan<Dim> planNodes(const RemeshingControls& controls, const MovedMesh<Dim>& moved, const std::vector<double>& h,
                        const std::vector<unsigned char>& kept, const std::vector<int>& pinched = {});

}  // namespace pfem
