#pragma once
// Eigenvalues of small symmetric matrices. Compiled once: Eigen's solvers cost the compiler seconds in each source.

#include <Eigen/Core>

namespace pfem {

/// A = sum_d values_d vectors_d vectors_d^T, ascending.
template <int N>
struct Spectrum {
    Eigen::Matrix<double, N, 1> values;
    Eigen::Matrix<double, N, N> vectors;  // of length 1, one a column
};

/// Of a symmetric matrix, whose lower half is read; N = 2, 3, 6.
template <int N>
Spectrum<N> spectrum(const Eigen::Matrix<double, N, N>& symmetric);

/// The eigenvalues alone, ascending; N = 3.
template <int N>
Eigen::Matrix<double, N, 1> eigenvalues(const Eigen::Matrix<double, N, N>& symmetric);

}  // namespace pfem
