#include "linear/saddle.hpp"

#include <algorithm>
#include <tuple>

#include "base/parallel.hpp"

namespace pfem {

namespace {

/// Entries (row, column, value) that forEntries visits, by rows, in the order of the visits.
template <class ForEntries>
SparseRows byRows(int n, const ForEntries& forEntries) {
    SparseRows rows;
    rows.start.assign(static_cast<std::size_t>(n) + 1, 0);
    forEntries([&](int i, int, double) { ++rows.start[i + 1]; });
    for (int i = 0; i < n; ++i) rows.start[i + 1] += rows.start[i];
    rows.column.resize(rows.start[n]);
    rows.value.resize(rows.start[n]);
    std::vector<int> next(rows.start.begin(), rows.start.end() - 1);
    forEntries([&](int i, int j, double value) {
        rows.column[next[i]] = j;
        rows.value[next[i]++] = value;
    });
    return rows;
}

/// The same row at the end of another matrix.
void appendRow(const SparseRows& A, int i, SparseRows& to) {
    to.column.insert(to.column.end(), A.column.begin() + A.start[i], A.column.begin() + A.start[i + 1]);
    to.value.insert(to.value.end(), A.value.begin() + A.start[i], A.value.begin() + A.start[i + 1]);
    to.start.push_back(static_cast<int>(to.column.size()));
}

}  // namespace

SymmetricMatrix diagonalOf(const SymmetricMatrix& A) {
    SymmetricMatrix D = symmetricPattern(std::vector<std::vector<int>>(A.n));
    for (int j = 0; j < A.n; ++j) D.value[j] = A.value[A.start[j]];
    return D;
}

Saddle split(const SymmetricMatrix& A, const SaddleSizes& sizes) {
    const int nP = sizes.nPressures;
    const auto forColumns = [&](const auto& visit) {  // visit(pressure, row, value)
        for (int j = 0; j < nP; ++j)
            for (int s = A.start[j]; s < A.start[j + 1]; ++s) visit(j, A.row[s], A.value[s]);
    };
    Saddle saddle;
    const auto splitPressures = [&] {
        saddle.K = byRows(nP, [&](const auto& visit) {
            forColumns([&](int j, int i, double value) {
                if (i >= nP) return;
                visit(i, j, value);
                if (i != j) visit(j, i, value);
            });
        });
    };
    const auto splitVelocities = [&] {
        saddle.B = byRows(nP, [&](const auto& visit) {
            forColumns([&](int j, int i, double value) {
                if (i >= nP) visit(j, i - nP, value);
            });
        });
        saddle.Bt = byRows(A.n - nP, [&](const auto& visit) {
            forColumns([&](int j, int i, double value) {
                if (i >= nP) visit(i - nP, j, value);
            });
        });
    };
    parallelInvoke(A.n, splitPressures, splitVelocities);
    for (int q = nP; q < A.n; ++q) {
        const double d = A.value[A.start[q]];
        saddle.inverse.push_back(d == 0 ? 0 : -1 / d);  // zero: a velocity whose cells are another rank's
    }
    return saddle;
}

SparseRows eliminateDiagonal(const Saddle& saddle, int first, int last) {
    const auto meetsVelocities = [&](int i) { return saddle.B.start[i] < saddle.B.start[i + 1]; };
    const auto forRow = [&](int i, SparseRow& row) {
        const auto& [K, B, Bt] = std::tie(saddle.K, saddle.B, saddle.Bt);
        for (int s = K.start[i]; s < K.start[i + 1]; ++s) row.add(K.column[s], K.value[s]);
        for (int s = B.start[i]; s < B.start[i + 1]; ++s) {
            const int q = B.column[s];
            const double factor = B.value[s] * saddle.inverse[q];
            for (int t = Bt.start[q]; t < Bt.start[q + 1]; ++t) row.add(Bt.column[t], factor * Bt.value[t]);
        }
    };
    return rowByRow(last - first, saddle.K.n(), [&](int own, SparseRow& row, SparseRows& S) {
        const int i = first + own;
        if (!meetsVelocities(i)) {
            appendRow(saddle.K, i, S);
            return;
        }
        forRow(i, row);
        row.sort();
        row.moveTo(S);
    });
}

}  // namespace pfem
