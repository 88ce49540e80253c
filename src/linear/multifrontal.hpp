#pragma once
// Direct solution of sparse symmetric quasi-definite systems by dense fronts.

#include <Eigen/Core>
#include <vector>

#include "linear/fronts.hpp"

namespace pfem {

/// A = L D L^T without pivoting, multifrontal: each front takes up what its children leave, eliminates its
/// columns and leaves the rest. The last unknowns can stay: what remains of them is their Schur complement. Computed as
/// `Real` and kept as `Stored`: solutions wait for the memory; with float they are good to some 1e-7 of the condition
/// number, and some 1e-6 of it when it is the `Real`, too (entries below 1e-38 are then zero).
template <class Stored, class Real = double>
class Multifrontal {
public:
    /// Factor the unknowns that have columns, piece by piece. Entries between the last ones are not looked at. Throws
    /// StepFailure when a pivot vanishes or is not finite.
    void factorize(const LowerColumns& A, const std::vector<Piece>& pieces);

    /// -A_lf A_ff^{-1} A_fl of the last unknowns, nLast x nLast.
    const Eigen::MatrixXd& lastBlock() const { return lastBlock_; }

    /// Forward elimination of the first unknowns: the last entries of b become b_l - A_lf A_ff^{-1} b_f.
    void eliminate(Eigen::VectorXd& b) const;

    /// x_f from eliminated first entries and the solution in the last ones.
    void backSubstitute(Eigen::VectorXd& x) const;

private:
    Fronts fronts_;
    std::vector<std::size_t> start_;  // of each front's block in values_
    Eigen::Matrix<Stored, Eigen::Dynamic, 1>
        values_;  // by columns: D and L of the front's columns, then the rows below
    Eigen::MatrixXd lastBlock_;
};

}  // namespace pfem
