#include "base/leastSquares.hpp"

#include <Eigen/QR>

namespace pfem {

Eigen::VectorXd leastSquares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
    return A.completeOrthogonalDecomposition().solve(b);
}

}  // namespace pfem
