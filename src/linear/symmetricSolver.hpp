#pragma once
// What all direct solvers of sparse symmetric systems have in common.

#include <Eigen/Core>

#include "linear/symmetricMatrix.hpp"

namespace pfem {

/// A x = b with one factor for many right-hand sides: analyse(A), factor(A), solve(b), in this order; factor(A) again
/// for other values on the same pattern.
class SymmetricSolver {
public:
    virtual ~SymmetricSolver() = default;

    /// The order of elimination and whatever else depends on the pattern of A alone.
    virtual void analyse(const SymmetricMatrix& A) = 0;

    /// The factor's numbers. A has the pattern that was analysed. Throws StepFailure when a pivot vanishes or is not
    /// finite; the solver can be used again.
    virtual void factor(const SymmetricMatrix& A) = 0;

    /// x of the factored A x = b.
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;

    /// The first unknowns of n, as many as b has, for a right-hand side that is zero beyond b.
    virtual Eigen::VectorXd solveFirst(const Eigen::VectorXd& b, int n) const {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(n);
        all.head(b.size()) = b;
        return solve(all).head(b.size());
    }

protected:
    SymmetricSolver() = default;
    SymmetricSolver(const SymmetricSolver&) = default;
    SymmetricSolver(SymmetricSolver&&) = default;
    SymmetricSolver& operator=(const SymmetricSolver&) = default;
    SymmetricSolver& operator=(SymmetricSolver&&) = default;
};

}  // namespace pfem
