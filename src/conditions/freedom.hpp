#pragma once
// In which directions a node may move.

#include <algorithm>

#include "base/types.hpp"

namespace pfem {

template <int Dim>
struct Freedom {
    int count = Dim;                              // of free directions
    Tensor<Dim> basis = Tensor<Dim>::Identity();  // its first `count` columns: they, orthonormal; the others are held

    bool any() const { return count > 0; }
    bool all() const { return count == Dim; }

    /// The part of u along the free directions.
    Vec<Dim> project(const Vec<Dim>& u) const {
        if (all()) return u;
        Vec<Dim> free = Vec<Dim>::Zero();
        for (int c = 0; c < count; ++c) free += basis.col(c) * basis.col(c).dot(u);
        return free;
    }
    /// What is left when motion along `normal` (any length) is held as well; nothing changes when it is held already,
    /// to a part of 1e-6.
    Freedom without(const Vec<Dim>& normal) const;
};

/// Orthonormal basis whose last column is the unit vector n.
template <int Dim>
Tensor<Dim> basisAround(const Vec<Dim>& n) {
    Tensor<Dim> basis;
    if constexpr (Dim == 2) {
        basis.col(0) = Vec<2>(-n[1], n[0]);
    } else {
        Eigen::Index axis = 0;
        n.cwiseAbs().minCoeff(&axis);
        basis.col(0) = (Vec<3>::Unit(axis) - n[axis] * n).normalized();
        basis.col(1) = n.cross(Vec<3>(basis.col(0)));
    }
    basis.col(Dim - 1) = n;
    return basis;
}

template <int Dim>
Freedom<Dim> Freedom<Dim>::without(const Vec<Dim>& normal) const {
    const Vec<Dim> part = project(normal);
    if (count == 0 || !(part.norm() > 1e-6 * normal.norm())) return *this;
    const Vec<Dim> n = part.normalized();
    if (all()) return {Dim - 1, basisAround<Dim>(n)};
    Freedom less = *this;
    less.count = count - 1;
    if (count == 2) {  // (3D) of a plane the direction across n is left
        Vec<Dim> left = basis.col(0) - n * n.dot(basis.col(0)), other = basis.col(1) - n * n.dot(basis.col(1));
        less.basis.col(0) = (left.squaredNorm() > other.squaredNorm() ? left : other).normalized();
    }
    less.basis.col(less.count) = n;
    return less;
}

}  // namespace pfem
