#include "base/spectrum.hpp"

#include <Eigen/Eigenvalues>

namespace pfem {

template <int N>
Spectrum<N> spectrum(const Eigen::Matrix<double, N, N>& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(symmetric);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

template <int N>
Eigen::Matrix<double, N, 1> eigenvalues(const Eigen::Matrix<double, N, N>& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

template Spectrum<2> spectrum<2>(const Eigen::Matrix<double, 2, 2>&);
template Spectrum<3> spectrum<3>(const Eigen::Matrix<double, 3, 3>&);
template Spectrum<6> spectrum<6>(const Eigen::Matrix<double, 6, 6>&);
template Eigen::Matrix<double, 3, 1> eigenvalues<3>(const Eigen::Matrix<double, 3, 3>&);

}  // namespace pfem
