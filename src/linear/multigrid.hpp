#pragma once
// Conjugate gradients preconditioned by algebraic multigrid (smoothed aggregation).

#include <functional>
#include <memory>

#include "linear/levels.hpp"

namespace pfem {

/// x of A x = b for symmetric positive definite matrices, by one multigrid for many right-hand sides.
class Multigrid {
public:
    using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

    /// `tolerance`: of the preconditioned residual, beside that of b. `rows`: who has which; all ranks have all of b
    /// and x (collective).
    explicit Multigrid(double tolerance, RankRows rows = {}) : tolerance_(tolerance), rows_(std::move(rows)) {}

    /// The levels for `A`, own rows with ascending columns. `apply`: the operator that is solved with them, on all
    /// unknowns, if it is not A.
    void setUp(SparseRows A, Operator apply = {});

    /// Throws StepFailure when the iteration does not converge.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

    int iterations() const { return iterations_; }  // of the last solution

private:
    Eigen::VectorXd product(const Eigen::VectorXd& own) const;
    double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

    double tolerance_;
    RankRows rows_;
    std::unique_ptr<Levels> levels_;
    Operator apply_;
    mutable int iterations_ = 0;
};

}  // namespace pfem
