#pragma once
// On which faces of walls does a point lie? One inside of a wall's side, two or more on an edge, three in a corner.

#include <vector>

#include "mesh/bins.hpp"
#include "mesh/mesh.hpp"

namespace pfem {

template <int Dim>
class WallSupports {
public:
    /// Faces of the patches that are walls, counted over all patches as in Nodes::wall. A point lies on a face within
    /// `tolerance` [m].
    WallSupports(const std::vector<Patch<Dim>>& patches, const std::vector<bool>& isWall, const Points<Dim>& x,
                 double tolerance);

    /// Ascending.
    std::vector<int> supportsOf(const Vec<Dim>& point) const;

    /// Their unit normals away from the fluid, without those that say the same (to 1e-6).
    std::vector<Vec<Dim>> normalsAt(const Vec<Dim>& point) const;

    const Face<Dim>& face(int number) const { return faces_[number]; }

private:
    const Points<Dim>& x_;
    double tolerance_;
    std::vector<Face<Dim>> faces_;  // of all patches
    std::vector<int> walls_;        // those of walls
    Bins<Dim> bins_;
};

/// The part of v that goes along all planes with these normals.
template <int Dim>
Vec<Dim> alongPlanes(Vec<Dim> v, const std::vector<Vec<Dim>>& normals);

}  // namespace pfem
