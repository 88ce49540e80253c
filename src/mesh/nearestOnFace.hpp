#pragma once
// The point of a face that is nearest to a point.

#include <limits>

#include "mesh/distance.hpp"

namespace pfem {

/// Weights of the face's nodes at its point nearest to `point`, 0 to 1 with sum 1 (2D: of a segment, 3D: of a triangle,
/// also of one without area).
template <int Dim>
Vec<Dim> nearestWeights(const Points<Dim>& x, const Face<Dim>& face, const Vec<Dim>& point) {
    if constexpr (Dim == 2) {
        const double w = nearestWeight<2>(x[face[0]], x[face[1]], point);
        return {1 - w, w};
    } else {  // the foot on the plane when it is within the triangle, else on the nearest edge
        if (Vec<3> foot = footWeights<3>(x, face, point); isWithin<3>(foot)) return foot;
        Vec<3> best = Vec<3>::Zero();
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            const double w = nearestWeight<3>(x[face[k]], x[face[next]], point);
            const double distance = ((1 - w) * x[face[k]] + w * x[face[next]] - point).squaredNorm();
            if (distance >= nearest) continue;
            nearest = distance;
            best.setZero();
            best[k] = 1 - w;
            best[next] = w;
        }
        return best;
    }
}

}  // namespace pfem
