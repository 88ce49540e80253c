#pragma once
// How far a point is from segments and faces.

#include <algorithm>
#include <cmath>

#include "mesh/onFace.hpp"

namespace pfem {

/// Where on the segment a-b is the point nearest to x: the weight of b, from 0 to 1. Of a segment without length: 0.
template <int Dim>
double nearestWeight(const Vec<Dim>& a, const Vec<Dim>& b, const Vec<Dim>& x) {
    const Vec<Dim> t = b - a;
    return t.squaredNorm() > 0 ? std::clamp((x - a).dot(t) / t.squaredNorm(), 0.0, 1.0) : 0.0;
}

/// Distance of x from the segment a-b.
template <int Dim>
double distanceToSegment(const Vec<Dim>& a, const Vec<Dim>& b, const Vec<Dim>& x) {
    return (x - a - nearestWeight<Dim>(a, b, x) * (b - a)).norm();
}

/// Distance of `point` from a face (2D: a segment, 3D: a triangle).
template <int Dim>
double distanceToFace(const Points<Dim>& x, const Face<Dim>& face, const Vec<Dim>& point) {
    if constexpr (Dim == 2) {
        return distanceToSegment<2>(x[face[0]], x[face[1]], point);
    } else {  // within the triangle from its plane, else from the nearest edge
        if (isWithin<3>(footWeights<3>(x, face, point))) {
            const Vec<3>& a = x[face[0]];
            const Vec<3> n = (x[face[1]] - a).cross(x[face[2]] - a);
            return std::abs(n.dot(point - a)) / n.norm();
        }
        double nearest = distanceToSegment<3>(x[face[0]], x[face[1]], point);
        for (const int k : {1, 2})
            nearest = std::min(nearest, distanceToSegment<3>(x[face[k]], x[face[(k + 1) % 3]], point));
        return nearest;
    }
}

}  // namespace pfem
