#pragma once
// Direct solution of sparse symmetric (quasi-)definite systems by CHOLMOD.

#include <Eigen/Core>
#include <memory>

#include "linear/symmetricMatrix.hpp"

namespace pfem {

/// A = P^T L D L^T P without pivoting: for positive definite and for quasi-definite matrices.
class Ldlt {
public:
    Ldlt();
    ~Ldlt();
    Ldlt(Ldlt&&) noexcept;
    Ldlt& operator=(Ldlt&&) noexcept;

    /// Fill-reducing ordering and pattern of L (approximate minimum degree).
    void analyze(const SymmetricMatrix& A);

    /// Numerical factorisation; the pattern must be the analysed one.
    /// Throws StepFailure when a pivot vanishes or is not finite.
    void factorize(const SymmetricMatrix& A);

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

private:
    struct Cholmod;
    std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace pfem
