#pragma once
// Direct solution of sparse symmetric (quasi-)definite systems by CHOLMOD.

#include <memory>

#include "linear/symmetricSolver.hpp"

namespace pfem {

/// A = P^T L D L^T P without pivoting: for positive definite and for quasi-definite matrices.
class Ldlt : public SymmetricSolver {
public:
    Ldlt();
    ~Ldlt() override;
    Ldlt(Ldlt&&) noexcept;
    Ldlt& operator=(Ldlt&&) noexcept;

    /// Fill-reducing ordering by approximate minimum degree.
    void analyse(const SymmetricMatrix& A) override;
    void factor(const SymmetricMatrix& A) override;
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;

private:
    struct Cholmod;
    std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace pfem
