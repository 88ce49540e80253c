#pragma once
// Pressures and velocities of a quasi-definite matrix [K B; B^T -M], the velocities eliminated: K + B M^{-1} B^T.

#include "base/unset.hpp"
#include "linear/symmetricMatrix.hpp"

namespace pfem {

/// A sparse matrix by rows.
struct SparseRows {
    std::vector<int> start{0};
    UnsetVector<int> column;
    UnsetVector<double> value;

    int n() const { return static_cast<int>(start.size()) - 1; }
};

/// y = A x.
Eigen::VectorXd multiply(const SparseRows& A, const Eigen::VectorXd& x);

/// The unknowns in their order: pressures (K positive definite), velocities with a matrix M of their own, velocities
/// whose M is diagonal.
struct SaddleSizes {
    int nPressures = 0;
    int nElastic = 0;
};

/// The blocks of [K B; B^T -M].
struct Saddle {
    SparseRows K, B, Bt;          // B: pressures x velocities, elastic ones first
    std::vector<double> inverse;  // of M's diagonal, per velocity
};

/// The diagonal of A, as a matrix.
SymmetricMatrix diagonalOf(const SymmetricMatrix& A);

/// Columns of A with ascending rows; so are the columns of each row of the blocks.
Saddle split(const SymmetricMatrix& A, const SaddleSizes& sizes);

/// K + B diag(M)^{-1} B^T, columns ascending: what is left of a matrix without elastic velocities, an estimate with
/// them. Of its rows those from `first` to `last` - 1; rows and columns of A that none of them meets need not be there.
SparseRows eliminateDiagonal(const Saddle& saddle, int first, int last);
inline SparseRows eliminateDiagonal(const Saddle& saddle) { return eliminateDiagonal(saddle, 0, saddle.K.n()); }

}  // namespace pfem
