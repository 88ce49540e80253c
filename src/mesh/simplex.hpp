#pragma once
// Geometry of one simplex with linear shape functions N_k (k = 0 ... Dim).

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/types.hpp"

namespace pfem {

/// measure = area (2D) or volume (3D), negative when inverted; gradN[k] = grad N_k, constant in the simplex.
template <int Dim>
struct SimplexGeometry {
    double measure;
    std::array<Vec<Dim>, Dim + 1> gradN;
};

/// measure = det J / Dim!,  J = [x_1 - x_0 ... x_Dim - x_0].
template <int Dim>
double simplexMeasure(const Points<Dim>& x, const Simplex<Dim>& s) {
    Tensor<Dim> J;
    for (int k = 0; k < Dim; ++k) J.col(k) = x[s[k + 1]] - x[s[0]];
    return J.determinant() / (Dim == 2 ? 2.0 : 6.0);
}

/// grad N_k = row k-1 of J^{-1} (k >= 1), grad N_0 = -sum of the others. A flat simplex has zero gradients.
template <int Dim>
SimplexGeometry<Dim> simplexGeometry(const Points<Dim>& x, const Simplex<Dim>& s) {
    Tensor<Dim> J;
    for (int k = 0; k < Dim; ++k) J.col(k) = x[s[k + 1]] - x[s[0]];
    SimplexGeometry<Dim> g;
    Vec<Dim> first;  // row of the adjugate: this is the innermost loop of all
    if constexpr (Dim == 3) first = J.col(1).cross(J.col(2));
    const double det = Dim == 2 ? J.determinant() : J.col(0).dot(first);
    g.measure = det / (Dim == 2 ? 2.0 : 6.0);
    if (det == 0.0) {
        g.gradN.fill(Vec<Dim>::Zero());
        return g;
    }
    const double scale = 1 / det;
    if constexpr (Dim == 2) {
        g.gradN[1] = {J(1, 1) * scale, -J(0, 1) * scale};
        g.gradN[2] = {-J(1, 0) * scale, J(0, 0) * scale};
    } else {
        g.gradN[1] = scale * first;
        g.gradN[2] = scale * J.col(2).cross(J.col(0));
        g.gradN[3] = scale * J.col(0).cross(J.col(1));
    }
    g.gradN[0].setZero();
    for (int k = 0; k < Dim; ++k) g.gradN[0] -= g.gradN[k + 1];
    return g;
}

/// Part of terms with |e| |grad N|^2 that a cell keeps: 1, but for slivers of tetrahedra, whose nodes lie nearly in a
/// plane though none is near another: with Q = |e|^(2/3) max |grad N|^2 (regular: 0.36) (4/Q)^(3/2) above Q = 4, so
/// that such terms vanish with the height instead of growing with its inverse. 2D: 1.
template <int Dim>
double sliverFactor(const SimplexGeometry<Dim>& g) {
    if constexpr (Dim == 2) return 1;
    double steepest = 0;
    for (const auto& gradN : g.gradN) steepest = std::max(steepest, gradN.squaredNorm());
    const double cubeOfQ = g.measure * g.measure * steepest * steepest * steepest;
    return cubeOfQ > 64 ? 8 / std::sqrt(cubeOfQ) : 1;
}

/// Is the simplex such a sliver?
template <int Dim>
bool isSliver(const Points<Dim>& x, const Simplex<Dim>& s) {
    if constexpr (Dim == 2) return false;
    const auto g = simplexGeometry<Dim>(x, s);
    return g.measure <= 0 || sliverFactor<Dim>(g) < 1;
}

/// div v = sum_k v_k . grad N_k of the velocities at its nodes: the rate of its measure, (d|measure|/dt)/|measure|
/// [1/s].
template <int Dim>
double simplexDivergence(const Points<Dim>& x, const Points<Dim>& v, const Simplex<Dim>& s) {
    const auto g = simplexGeometry<Dim>(x, s);
    double div = 0;
    for (int k = 0; k <= Dim; ++k) div += v[s[k]].dot(g.gradN[k]);
    return div;
}

/// Does the simplex hold the point, its boundary included (to 1e-12 of each height)? Never when it is inverted.
template <int Dim>
bool holds(const Points<Dim>& x, const Simplex<Dim>& s, const Vec<Dim>& point) {
    if constexpr (Dim == 2) {
        const Vec<2> a = x[s[0]] - point, b = x[s[1]] - point, c = x[s[2]] - point;
        const double bc = b[0] * c[1] - b[1] * c[0], ca = c[0] * a[1] - c[1] * a[0], ab = a[0] * b[1] - a[1] * b[0];
        const double det = bc + ca + ab;
        return det > 0 && bc >= -1e-12 * det && ca >= -1e-12 * det && ab >= -1e-12 * det;
    } else {  // six times the volumes with the point in the place of each node
        const Vec<3> a = x[s[0]] - point, b = x[s[1]] - point, c = x[s[2]] - point, d = x[s[3]] - point;
        const Vec<3> ab = a.cross(b), cd = c.cross(d);
        const double parts[] = {b.dot(cd), -a.dot(cd), ab.dot(d), -ab.dot(c)};
        const double det = (parts[0] + parts[1]) + (parts[2] + parts[3]);
        return det > 0 && *std::min_element(parts, parts + 4) >= -1e-12 * det;
    }
}

/// Centroid.
template <int Dim>
Vec<Dim> simplexCentroid(const Points<Dim>& x, const Simplex<Dim>& s) {
    Vec<Dim> c = Vec<Dim>::Zero();
    for (int node : s) c += x[node];
    return c / (Dim + 1);
}

/// Circumradius; infinite for a flat simplex. 2D: R = abc / (4 |A|); 3D: R = |a^2 (b x c) + b^2 (c x a) + c^2 (a x b)|
/// / (12 |V|) with the edges a, b, c from one node.
template <int Dim>
double circumradius(const Points<Dim>& x, const Simplex<Dim>& s);

/// The face opposite to local node k, oriented with the simplex on its left (2D) / outward normal by the
/// right-hand rule (3D).
template <int Dim>
Face<Dim> oppositeFace(const Simplex<Dim>& s, int k) {
    if constexpr (Dim == 2) {
        return {s[(k + 1) % 3], s[(k + 2) % 3]};
    } else {
        constexpr int face[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        return {s[face[k][0]], s[face[k][1]], s[face[k][2]]};
    }
}

/// Outward area vector of a face: its measure times the normal away from the cell.
template <int Dim>
Vec<Dim> faceArea(const Points<Dim>& x, const Face<Dim>& face) {
    if constexpr (Dim == 2) {
        const Vec<2> t = x[face[1]] - x[face[0]];
        return {t[1], -t[0]};
    } else {
        const Vec<3> a = x[face[1]] - x[face[0]];
        const Vec<3> b = x[face[2]] - x[face[0]];
        return 0.5 * a.cross(b);
    }
}

}  // namespace pfem
