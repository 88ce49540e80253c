#pragma once
// The levels of a multigrid by smoothed aggregation, and its cycle.

#include "linear/aggregation.hpp"
#include "linear/blockSweeps.hpp"
#include "linear/ldlt.hpp"

namespace pfem {

/// V cycle: a forward sweep, what is left on the next level, a backward sweep; a factor on the last. It is symmetric and
/// positive definite where A is.
class Levels {
public:
    /// Columns of A ascending, its diagonal among them. Throws StepFailure when the last level's matrix is singular.
    explicit Levels(SparseRows A);

    const SparseRows& matrix() const { return A_; }

    /// An approximate inverse of A, times b.
    Eigen::VectorXd cycle(const Eigen::VectorXd& b) const;

private:
    struct Level {
        BlockSweeps sweeps;
        SparseRows prolongation, restriction;  // from the next level and to it
    };
    Eigen::VectorXd cycle(std::size_t level, const Eigen::VectorXd& b) const;

    SparseRows A_;
    std::vector<Level> levels_;  // but for the last
    Ldlt factor_;
};

}  // namespace pfem
