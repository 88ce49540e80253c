#pragma once
// Direct solution of sparse symmetric (quasi-)definite systems; the only place that knows CHOLMOD.

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

    /// Analysis and factorisation with the unknowns eliminated in the order they have. The last nLast of them can be
    /// treated apart, see below. Throws as above.
    void factorize(const LowerRows& A, int nLast = 0);

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

    /// Schur complement of the last unknowns, nLast x nLast: A_ll - A_lf A_ff^{-1} A_fl, f the first ones.
    Eigen::MatrixXd lastBlock() const;

    /// Forward elimination of the first unknowns: the last entries of b become b_l - A_lf A_ff^{-1} b_f.
    void eliminate(Eigen::VectorXd& b) const;

    /// x_f from eliminated first entries and the solution in the last ones.
    void backSubstitute(Eigen::VectorXd& x) const;

private:
    struct Cholmod;
    std::unique_ptr<Cholmod> cholmod_;
};

/// The unknowns in an order of elimination with little fill (approximate minimum degree).
std::vector<int> minimumDegree(const MatrixGraph& graph);

}  // namespace pfem
