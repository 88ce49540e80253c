#pragma once
// Small systems without a unique solution.

#include "base/types.hpp"

namespace pfem {

/// The shortest x among those for which |A x - b| is least; any shape and rank.
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace pfem
