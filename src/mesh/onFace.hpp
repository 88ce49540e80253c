#pragma once
// Values on a face of a wall or solid.

#include <Eigen/Geometry>

#include "base/types.hpp"

namespace pfem {

/// Weights of the face's nodes at the foot of a point on its line or plane; not within it: one is negative. Of a face
/// without area: no numbers.
template <int Dim>
Vec<Dim> footWeights(const Points<Dim>& x, const Face<Dim>& face, const Vec<Dim>& point) {
    const Vec<Dim>& a = x[face[0]];
    const Vec<Dim> b = x[face[1]] - a, p = point - a;
    if constexpr (Dim == 2) {
        const double s = b.dot(p) / b.squaredNorm();
        return {1 - s, s};
    } else {
        const Vec<3> c = x[face[2]] - a, n = b.cross(c);
        const double area = n.squaredNorm(), s = p.cross(c).dot(n) / area, t = b.cross(p).dot(n) / area;
        return {1 - s - t, s, t};
    }
}

/// Is the foot with these weights on the face?
template <int Dim>
bool isWithin(const Vec<Dim>& weights) {
    return (weights.array() >= 0).all();
}

/// The mean of the nodes' values by these weights.
template <int Dim>
Vec<Dim> weighted(const Points<Dim>& value, const Face<Dim>& face, const Vec<Dim>& weights) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int k = 0; k < Dim; ++k) sum += weights[k] * value[face[k]];
    return sum;
}

/// The values at the face's nodes, interpolated at the foot of a point.
template <int Dim>
Vec<Dim> onFace(const Points<Dim>& x, const Face<Dim>& face, const Vec<Dim>& point, const Points<Dim>& value) {
    return weighted<Dim>(value, face, footWeights<Dim>(x, face, point));
}

}  // namespace pfem
