#pragma once
// What a plane (3D; 2D: a line) cuts out of cells.

#include <optional>

#include "mesh/mesh.hpp"

namespace pfem {

/// A plane of the points x with normal . (x - point) = 0; `normal` is a unit vector.
template <int Dim>
struct Plane {
    Vec<Dim> point = Vec<Dim>::Zero(), normal = Vec<Dim>::Zero();
};

/// A point on the edge of a cell, or (a == b) a node: (1 - weight) x_a + weight x_b with a <= b.
struct EdgePoint {
    int a = 0, b = 0;
    double weight = 0;  // of b
};

/// Value there.
template <class Value>
Value valueAt(const EdgePoint& at, const std::vector<Value>& values) {
    if (at.a == at.b) return values[at.a];
    return (1 - at.weight) * values[at.a] + at.weight * values[at.b];
}

/// What the plane cuts out of one cell: 2 points in 2D, in 3D 3 or 4 in a circle that turns right about the normal.
struct CutPiece {
    int cell = -1;
    int n = 0;
    std::array<EdgePoint, 4> points{};
};

/// The pieces of all cells in their order. A face of cells that lies in the plane counts once, with the cell behind it.
template <int Dim>
std::vector<CutPiece> cutByPlane(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells, const Plane<Dim>& plane);

/// Length [m] (2D) or area [m2] of a piece times the mean of a linear field over it: int f dA.
template <int Dim>
double integralOver(const CutPiece& piece, const Points<Dim>& x, const std::vector<double>& f);

}  // namespace pfem
