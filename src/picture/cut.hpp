#pragma once
// What a plane leaves of triangles and lines, and its section with tetrahedra.

#include <optional>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// What lies on the side of the normal is taken away.
struct CuttingPlane {
    Vec<3> point, normal;

    double beyond(const Vec<3>& x) const { return normal.dot(x - point); }
};

/// A corner of what is drawn: place, normal of the surface, value of the field.
struct Corner3 {
    Vec<3> x;
    Vec<3> normal = Vec<3>::Zero();
    double value = 0;
};

using Corners3 = std::vector<Corner3>;

/// The part of a convex polygon that is left. Neighbours get the same points on their common edge.
Corners3 partLeft(const CuttingPlane& plane, const Corners3& polygon);

/// The section with a tetrahedron: a triangle, a quadrangle or nothing. Tetrahedra that touch the plane from the side
/// that is left have their face there, those beyond have none.
Corners3 section(const CuttingPlane& plane, const std::array<Corner3, 4>& corners);

/// The line in which the plane crosses a triangle.
std::optional<std::array<Vec<3>, 2>> trace(const CuttingPlane& plane, const std::array<Vec<3>, 3>& triangle);

/// The part of a line that is left.
std::optional<std::array<Vec<3>, 2>> partLeft(const CuttingPlane& plane, const std::array<Vec<3>, 2>& line);

}  // namespace pfem
