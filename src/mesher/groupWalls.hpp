#pragma once
// Walls of a mesh file: groups of edges, or lines of points along the file's triangles. Internal to src/mesher.

#include <map>
#include <set>

#include "mesher/draft.hpp"

namespace pfem {

/// Edges of triangles, the triangle on the left of a -> b, and whose it is.
using Sides = std::map<Face<2>, BodyType>;

struct WallEdge {
    Face<2> nodes;
    int line = 0;  // in the file
};

/// An edge of a wall between two bodies.
struct WallBetween {
    int node;
    int line;
};

/// The edges with the body that they bound on the left; dry ones as their neighbours along the wall or, where there is
/// none, as they are. Edges of solids are left out. Throws WallBetween.
std::vector<Face<2>> orientWall(const std::vector<WallEdge>& edges, const Sides& sides);

/// A wall given by points: its corners, and what lies of the bodies' outlines on it.
/// Throws UserError: arcs, a body on the right of the wall.
void addPointWall(const Wall& wall, const Sides& sides, double meanSize, Draft& draft, Patch<2>& patch);

/// Bodies that touch must share their nodes. Throws UserError with the place.
void checkTouching(const Draft& draft, const Sides& sides, double meanSize);

}  // namespace pfem
