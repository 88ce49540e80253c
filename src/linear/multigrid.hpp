#pragma once
// Conjugate gradients preconditioned by algebraic multigrid (smoothed aggregation).

#include <functional>
#include <memory>

#include "linear/levels.hpp"

namespace pfem {

/// x of A x = b for symmetric positive definite matrices, by one preconditioner for many right-hand sides.
class IterativeSolver {
public:
    using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

    virtual ~IterativeSolver() = default;

    /// The preconditioner of `A`, own rows with ascending columns. `apply`: the operator that is solved with it, if it
    /// is not A.
    virtual void setUp(SparseRows A, Operator apply) = 0;

    /// Throws StepFailure when the iteration does not converge.
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;

    virtual int iterations() const = 0;  // of the last solution

protected:
    IterativeSolver() = default;
    IterativeSolver(const IterativeSolver&) = default;
    IterativeSolver(IterativeSolver&&) = default;
    IterativeSolver& operator=(const IterativeSolver&) = default;
    IterativeSolver& operator=(IterativeSolver&&) = default;
};

/// In one process.
class Multigrid : public IterativeSolver {
public:
    /// `tolerance`: of the preconditioned residual, beside that of b.
    explicit Multigrid(double tolerance) : tolerance_(tolerance) {}

    void setUp(SparseRows A, Operator apply = {}) override;
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;
    int iterations() const override { return iterations_; }

private:
    double tolerance_;
    std::unique_ptr<Levels> levels_;
    Operator apply_;
    mutable int iterations_ = 0;
};

}  // namespace pfem
