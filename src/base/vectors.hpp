#pragma once
// Vectors of the plane and of space.

#include <Eigen/Core>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// The component of a x b out of the plane.
inline double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// With three components: what is in the plane has z = 0.
template <int Dim>
Eigen::Vector3d inSpace(const Vec<Dim>& v) {
    return {v[0], v[1], Dim == 3 ? v[Dim - 1] : 0.0};
}

/// The same for a table.
template <int Dim>
std::vector<double> threeNumbers(const Vec<Dim>& v) {
    const Eigen::Vector3d x = inSpace<Dim>(v);
    return {x.begin(), x.end()};
}

}  // namespace pfem
