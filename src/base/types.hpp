#pragma once
// Basic types. Everything on simplices is written for any Dim (2 = triangles, 3 = tetrahedra).

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace pfem {

using Id = std::int64_t;  // a node's name for life: never reused, also after its removal

template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;

template <int Dim>
using Tensor = Eigen::Matrix<double, Dim, Dim>;

template <int Dim>
using Simplex = std::array<int, Dim + 1>;  // node indices, positively oriented

template <int Dim>
using Face = std::array<int, Dim>;  // node indices of a simplex's face

template <int Dim>
using Points = std::vector<Vec<Dim>>;

/// Components of a symmetric stress: 2D (plane strain) xx yy zz xy, 3D xx yy zz xy yz xz.
template <int Dim>
inline constexpr int nStress = Dim == 2 ? 4 : 6;

template <int Dim>
using Stress = Eigen::Matrix<double, nStress<Dim>, 1>;

}  // namespace pfem
