#pragma once
// Gauss and Seidel's sweeps in blocks of rows at the same time: their bits do not depend on the number of threads.

#include "linear/sparseRows.hpp"

namespace pfem {

/// Blocks of rows of a symmetric matrix that are swept at the same time, each with what the others had before. Blocks
/// know nothing of each other within a sweep: where many meet, in rows of nodes that came late, sweeps overshoot, and
/// the cycle is indefinite. `added` to the diagonal, half the sum of what is of other blocks, in absolute values, makes
/// M = D' + L of a forward sweep (L: what is below the diagonal in its block) such that
/// M + M^T - A = D + 2 E - O > 0, for x.O x <= 2 x.E x, O the entries of other blocks (Baker, Falgout, Kolev, Yang
/// 2011). Of L, the entries are in single precision, and L^T is L by columns: what a sweep costs is memory.
class BlockSweeps {
public:
    BlockSweeps() = default;
    /// Columns of A ascending, its diagonal among them.
    explicit BlockSweeps(const SparseRows& A);

    /// x = M^{-1} b, r = b - A x = (M - A) x.
    void forward(const Eigen::VectorXd& b, Eigen::VectorXd& x, Eigen::VectorXd& r) const;

    /// x += M^{-T} (b - A x). `t`: memory of the same size.
    void backward(const Eigen::VectorXd& b, Eigen::VectorXd& x, Eigen::VectorXd& t) const;

private:
    struct Diagonal {
        double added, inverse;  // the latter of the diagonal with it
    };
    int first(int block) const { return block == 0 ? 0 : ends_[block - 1]; }
    int size() const { return static_cast<int>(ends_.size()); }

    std::vector<int> ends_;  // of the blocks
    std::vector<Diagonal> diagonal_;
    std::vector<int> start_, column_;  // of L
    std::vector<float> value_;
    std::vector<int> meets_;  // rows with entries of other blocks
    SparseRows others_;       // these rows, and all entries of other blocks
};

}  // namespace pfem
