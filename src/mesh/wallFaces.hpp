#pragma once
// Rigid walls as one geometry: faces that join to regions along which nodes slide.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/supports.hpp"

namespace pfem {

/// How a wall goes on beyond an edge of a face (2D: an end).
enum class Bend : unsigned char {
    open,    // not at all
    smooth,  // by less than featureAngle: the same region
    convex,  // away from the fluid
    concave  // towards the fluid
};

/// Faces that meet at less than this belong to one smooth region [degrees].
inline constexpr double featureAngle = 20;

/// A face of a patch; of a rigid wall it has a region.
template <int Dim>
struct WallFace {
    Face<Dim> nodes;   // points of the wall, fluid on the left (2D)
    int patch = -1;    // -1: the face is not of a wall
    int region = -1;   // of the walls
    Face<Dim> next{};  // the face beyond the edge opposite to node k, -1: none
    std::array<Bend, Dim> bend{};
    bool bent = false;                   // its region is, here
    std::array<Vec<Dim>, Dim> normal{};  // into the fluid at each node: the mean of the region's faces there
};

/// Is one of these faces of this region?
template <int Dim>
bool isOnRegion(const std::vector<WallFace<Dim>>& walls, const Supports<Dim>& supports, int region) {
    return std::any_of(supports.begin(), supports.end(),
                       [&](int face) { return face >= 0 && walls[face].region == region; });
}

/// All faces of all patches in their order, as counted by Nodes::wall. `isWall`: per patch; x: of the walls' points.
template <int Dim>
std::vector<WallFace<Dim>> wallFaces(const std::vector<Patch<Dim>>& patches, const std::vector<bool>& isWall,
                                     const Points<Dim>& x);

/// Pairs of regions that meet at a convex edge: water goes round it. Sorted, both ways.
template <int Dim>
std::vector<std::pair<int, int>> convexPairs(const std::vector<WallFace<Dim>>& walls);

/// Normal of a wall face into the fluid.
template <int Dim>
Vec<Dim> inwardNormal(const Points<Dim>& x, const Face<Dim>& face);

/// Where a point belongs on the smooth region of a face.
template <int Dim>
struct WallPlace {
    int face = -1;
    Vec<Dim> x = Vec<Dim>::Zero();       // the nearest point of the region
    Vec<Dim> normal = Vec<Dim>::Zero();  // there, into the fluid
    int beyond = -1;                     // the point lies beyond this edge of `face`, with which the region ends
};

/// Walks from `face` over its region to the face nearest to the point. A bent region is as smooth as it is meant:
/// between its points it is a curve of third order with the normals there (2D).
template <int Dim>
WallPlace<Dim> placeOnRegion(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x, int face,
                             const Vec<Dim>& point);

}  // namespace pfem
