#pragma once
// One body after the division of its boundary: what the fillers of its inside work on.

#include "mesher/meshDescription.hpp"
#include "mesher/sizeField.hpp"

namespace pfem {

/// A point that may move no further than `radius` from x.
struct Anchor {
    Vec<2> x;
    double radius;  // [m]
};

/// Points 0 .. nBoundary-1 lie on the boundary and stay; those of the inside follow.
struct Region {
    Points<2> x;
    int nBoundary = 0;
    int nLoops = 0;                 // outline and holes
    std::vector<int> boundaryNode;  // of BoundaryNodes, per boundary point
    std::vector<Face<2>> edges;     // the body on the left of a -> b; first the outer loop, then holes
    std::vector<bool> onWall;       // per edge: part of a rigid wall
    std::vector<Anchor> anchors;    // of the first inner points: those beside corners
    bool fluid = true;
    double h = 0;                           // the body's size [m]
    Vec<2> rowDirection = Vec<2>::UnitX();  // of the lattice: along the longest straight edge
    Vec<2> rowOrigin = Vec<2>::Zero();      // a node on that edge
    double rowSpacing = 0;                  // of the nodes on that edge, were it divided evenly [m]

    double area() const;       // [m2]
    double perimeter() const;  // [m]
    bool contains(const Vec<2>& point) const;

    /// A point inside, next to the outer loop.
    Vec<2> probe() const;
};

/// The inside of the body's outline, holes included: its edges only.
Region outlineRegion(int body, const Arrangement& arrangement, const BoundaryNodes& boundary);

/// Where a hole touches the outline or another one, a boundary point may have more than two edges.
Region regionOf(const MeshDescription& mesh, int body, const Arrangement& arrangement, const BoundaryNodes& boundary);

/// Fill the region with nearly equilateral triangles; adds its inner points.
std::vector<Simplex<2>> fillUnstructured(Region& region, const SizeField& size);

/// Fill a four-sided region with `cells` along its edges 0-1 and 1-2; adds its inner points.
std::vector<Simplex<2>> fillPattern(Region& region, Pattern pattern, std::array<int, 2> cells);

// ---- the steps of fillUnstructured ----

/// Anchored points on the bisectors of corners, so that a corner has at least two triangles.
void seedCorners(Region& region);

/// Points of hexagonal lattices at the wanted distance.
void seedLattice(Region& region, const SizeField& size);

/// Move the inner points until the triangles are nearly equilateral; returns the triangles.
std::vector<Simplex<2>> smoothAndTriangulate(Region& region, const SizeField& size);

}  // namespace pfem
