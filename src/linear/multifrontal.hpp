#pragma once
// Direct solution of sparse symmetric quasi-definite systems by dense fronts.

#include <Eigen/Core>
#include <vector>

#include "linear/eliminationTree.hpp"

namespace pfem {

/// A = P^T L D L^T P without pivoting, multifrontal: each front takes up what its children leave, eliminates its
/// columns and leaves the rest. The last unknowns can stay: what remains of them is their Schur complement.
class Multifrontal {
public:
    /// Factor all but the last nLast unknowns. Unknowns come in an order with little fill. Entries between the last
    /// ones are not looked at. Throws StepFailure when a pivot vanishes or is not finite.
    void factorize(const LowerRows& A, int nLast = 0);

    /// -A_lf A_ff^{-1} A_fl of the last unknowns, nLast x nLast.
    const Eigen::MatrixXd& lastBlock() const { return lastBlock_; }

    /// Forward elimination of the first unknowns: the last entries of b become b_l - A_lf A_ff^{-1} b_f.
    void eliminate(Eigen::VectorXd& b) const;

    /// x_f from eliminated first entries and the solution in the last ones.
    void backSubstitute(Eigen::VectorXd& x) const;

private:
    EliminationTree tree_;
    std::vector<std::size_t> start_;  // of each front's block in values_
    std::vector<double> values_;      // by columns: D and L of the front's columns, then the rows below
    Eigen::MatrixXd lastBlock_;
};

}  // namespace pfem
