#pragma once
// Smoothed aggregation (Vanek, Mandel, Brezina 1996): the coarse matrix of a symmetric one by its entries alone.

#include "linear/sparseRows.hpp"

namespace pfem {

/// Which rows go together: each row without a neighbour in an aggregate begins one with all its neighbours, those left
/// go to the neighbour they are joined to most.
struct Aggregates {
    std::vector<int> of;  // each row; -1: it meets no other, and its equation needs no coarse one
    int count = 0;
};
Aggregates aggregates(const SparseRows& A);

/// (I - 4/3 D^{-1} A) P0, P0 one on each aggregate's rows: constants, smoothed. D_i = sum_j |A_ij|, so that no
/// eigenvalue of D^{-1} A is above one.
SparseRows prolongation(const SparseRows& A, const Aggregates& aggregates);

/// A^T, A with so many columns.
SparseRows transposed(const SparseRows& A, int nColumns);

/// P^T A P = X + X^T, X = P^T (L + D/2) P, L and D what A has below and on its diagonal; R = P^T. Columns of A ascending,
/// its diagonal among them.
SparseRows coarseMatrix(const SparseRows& A, const SparseRows& P, const SparseRows& R);

}  // namespace pfem
