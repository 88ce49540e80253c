#pragma once
// The edges that a mesh has to show: sharp edges of surfaces, and where surfaces of bodies cross each other.

#include "mesher/space/spaceDomain.hpp"

namespace pfem {

/// Two faces that meet at a larger angle than this have a sharp edge, two pieces of a line a corner [cos].
constexpr double sharpCosine = 0.8660254;  // of 30 degrees, just below

/// Lines without branches, of straight pieces; ends and branches are corners. A closed line has its first point again
/// at its end. Only what lies between different labels. `size`: of the cells [m].
std::vector<Points<3>> featureLines(const SpaceDomain& domain, double size);

/// The sharp edges of a surface: between regions, between faces at an angle, and its rim.
std::vector<std::array<int, 2>> sharpEdges(const TriSurface& surface);

/// Where two triangles cross: two points; nothing where they touch along an edge of both, or lie in one plane.
std::optional<std::array<Vec<3>, 2>> crossingLine(const BoxTree::Triangle& a, const BoxTree::Triangle& b,
                                                  double tolerance);

}  // namespace pfem
