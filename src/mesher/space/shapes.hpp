#pragma once
// Surfaces of OpenFOAM's simple shapes. Lengths in metres.

#include "mesh/triSurface.hpp"

namespace pfem {

/// Regions xMin xMax yMin yMax zMin zMax.
TriSurface boxSurface(const Vec<3>& low, const Vec<3>& high);

/// A frustum between two discs with the radii r1 at p1 and r2 at p2, one of which may be 0; regions side end1 end2.
/// `segments`: of its circles.
TriSurface coneSurface(const Vec<3>& p1, double r1, const Vec<3>& p2, double r2, int segments);

/// Region surface. `segments`: of its great circles, a multiple of 4.
TriSurface sphereSurface(const Vec<3>& centre, double radius, int segments);

/// A square with this side length round `centre`; region plane; the normal is that of the triangles.
TriSurface planeSurface(const Vec<3>& centre, const Vec<3>& normal, double side);

/// A circular face; region disk.
TriSurface diskSurface(const Vec<3>& centre, const Vec<3>& normal, double radius, int segments);

/// A polygon in the plane, counter-clockwise. Piece k begins at point k and is a part of edge[k]: of an arc there are
/// several pieces.
struct Polygon {
    Points<2> points;
    std::vector<int> edge;
};

/// A polygon in the plane z = 0 moved by `by`; regions start and end, and edge0 edge1 ... of
/// the polygon's edges, named by Polygon::edge.
TriSurface extrudedSurface(const Polygon& polygon, const Vec<3>& from, const Vec<3>& by);

/// A polygon turned round an axis (0: x, 1: y, 2: z) by `angle` [rad]. Its points are (x r), (r y) or (r z) with the
/// distance r >= 0 from the axis. Regions edge0 ..., and start and end when the angle is less than a whole turn.
TriSurface turnedSurface(const Polygon& polygon, int axis, double angle, int segments);

/// Triangles of a simple polygon, counter-clockwise, by its vertices. Throws UserError when it crosses itself.
std::vector<Face<3>> polygonTriangles(const Points<2>& polygon);

}  // namespace pfem
