#pragma once
// A surface of triangles: its edges, and normals for its light.

#include <vector>

#include "base/types.hpp"

namespace pfem {

/// An edge of a surface and two of its faces; `faces[1]` is -1 at the surface's end.
struct SkinEdge {
    int a, b;
    std::array<int, 2> faces;
    int count;  // of the faces that meet here
};

/// Sorted by their nodes.
std::vector<SkinEdge> skinEdges(const std::vector<Face<3>>& faces);

/// Unit normals of the faces, by the right-hand rule; zero without an area.
Points<3> faceNormals(const std::vector<Face<3>>& faces, const Points<3>& x);

/// Faces that meet at less than this are lit as one round surface [degrees].
inline constexpr double creaseAngle = 40;

/// The normals at each face's corners: the mean, by area, of those faces at the node that are on the same round
/// surface.
std::vector<std::array<Vec<3>, 3>> cornerNormals(const std::vector<Face<3>>& faces, const Points<3>& x);

}  // namespace pfem
