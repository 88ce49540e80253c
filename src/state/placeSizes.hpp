#pragma once
// Mesh sizes that belong to places (holdSizes of system/meshDict): nodes take the size of where they are.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// Increase of the mesh size per distance from a place of finer mesh.
inline constexpr double sizeGrowth = 0.2;

/// A place of finer mesh: a box, or what is near to faces: segments of a curve, triangles of a surface, a single point
/// (all corners are the same), or a patch, wherever it has moved.
template <int Dim>
struct SizePlace {
    using Corners = std::array<Vec<Dim>, Dim>;

    double meshSize = 0;                              // [m]
    double distance = 0;                              // from the faces: so far the size holds [m]
    std::optional<std::array<Vec<Dim>, 2>> box = {};  // its lowest and its highest corner [m]
    std::vector<Corners> faces = {};                  // [m]
    std::string patch = {};                           // its name
};

/// All such places. The surfaces of solids count beside them, with the sizes of their nodes.
template <int Dim>
struct PlaceSizes {
    double coarsest = 0;  // far away from all of them [m]; 0: nodes keep the size that they have
    std::vector<SizePlace<Dim>> places = {};

    bool hold() const { return coarsest > 0; }
};

/// Distance of x from a box, 0 within.
template <int Dim>
double distanceToBox(const Vec<Dim>& x, const Vec<Dim>& low, const Vec<Dim>& high) {
    return (low - x).cwiseMax(x - high).cwiseMax(Vec<Dim>::Zero()).norm();
}

}  // namespace pfem
