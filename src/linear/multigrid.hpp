#pragma once
// Conjugate gradients preconditioned by algebraic multigrid (PETSc's smoothed aggregation).

#include <functional>
#include <memory>

#include "linear/rankRows.hpp"
#include "linear/saddle.hpp"

namespace pfem {

/// Is PETSc in this build (CMake's PFEM_PETSC)?
bool hasMultigrid();

/// x of A x = b for symmetric positive definite matrices, by one multigrid for many right-hand sides.
class Multigrid {
public:
    using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

    /// `tolerance`: of the preconditioned residual, beside that of b. `rows`: who has which; all ranks have all of b
    /// and x. Throws UserError in a build without PETSc.
    explicit Multigrid(double tolerance, RankRows rows = {});
    ~Multigrid();

    /// The levels for `A`, own rows with ascending columns. `apply`: the operator that is solved with them, if it is
    /// not A. Where there are several threads, one of their own makes them beside what comes next, until the first
    /// solution.
    void setUp(SparseRows A, Operator apply = {});

    /// Throws StepFailure when the iteration does not converge.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

    int iterations() const;  // of the last solution

private:
    struct Petsc;
    std::unique_ptr<Petsc> petsc_;
};

}  // namespace pfem
