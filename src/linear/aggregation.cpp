#include "linear/aggregation.hpp"

#include <cmath>

namespace pfem {

namespace {

constexpr int none = -1;

/// Calls visit(j, a) for each neighbour of row i.
template <class Visit>
void forNeighbours(const SparseRows& A, int i, const Visit& visit) {
    for (int s = A.start[i]; s < A.start[i + 1]; ++s)
        if (A.column[s] != i && A.value[s] != 0) visit(A.column[s], A.value[s]);
}

/// Rows none of whose neighbours is in an aggregate, with all of these.
void beginAggregates(const SparseRows& A, Aggregates& aggregates) {
    for (int i = 0; i < A.n(); ++i) {
        bool isAlone = true, isFree = aggregates.of[i] == none;
        for (int s = A.start[i]; isFree && s < A.start[i + 1]; ++s) {
            if (A.column[s] == i || A.value[s] == 0) continue;
            isAlone = false;
            isFree = aggregates.of[A.column[s]] == none;
        }
        if (!isFree || isAlone) continue;
        aggregates.of[i] = aggregates.count;
        forNeighbours(A, i, [&](int j, double) { aggregates.of[j] = aggregates.count; });
        ++aggregates.count;
    }
}

/// The aggregate, of those there are in `of`, of the neighbour that row i is joined to most; -1 without any.
int nearest(const SparseRows& A, const std::vector<int>& of, int i) {
    double most = 0;
    int found = none;
    forNeighbours(A, i, [&](int j, double a) {
        if (of[j] == none || std::abs(a) <= most) return;
        most = std::abs(a);
        found = of[j];
    });
    return found;
}

}  // namespace

Aggregates aggregates(const SparseRows& A) {
    Aggregates aggregates{std::vector<int>(A.n(), none), 0};
    beginAggregates(A, aggregates);
    const std::vector<int> begun = aggregates.of;
    parallelFor(A.n(), [&](int i) {
        if (begun[i] == none) aggregates.of[i] = nearest(A, begun, i);
    });
    return aggregates;
}

SparseRows prolongation(const SparseRows& A, const Aggregates& aggregates) {
    const std::vector<int>& of = aggregates.of;
    return rowByRow(A.n(), aggregates.count, [&](int i, SparseRow& row, SparseRows& P) {
        double sum = 0;
        for (int s = A.start[i]; s < A.start[i + 1]; ++s) sum += std::abs(A.value[s]);
        if (of[i] != none) row.add(of[i], 1);
        for (int s = A.start[i]; s < A.start[i + 1]; ++s)
            if (of[A.column[s]] != none) row.add(of[A.column[s]], -4.0 / 3.0 * A.value[s] / sum);
        row.moveTo(P);
    });
}

SparseRows transposed(const SparseRows& A, int nColumns) {
    SparseRows T;
    T.start.assign(static_cast<std::size_t>(nColumns) + 1, 0);
    for (const int j : A.column) ++T.start[j + 1];
    for (int j = 0; j < nColumns; ++j) T.start[j + 1] += T.start[j];
    T.column.resize(A.column.size());
    T.value.resize(A.column.size());
    std::vector<int> next(T.start.begin(), T.start.end() - 1);
    for (int i = 0; i < A.n(); ++i)
        for (int s = A.start[i]; s < A.start[i + 1]; ++s) {
            const int t = next[A.column[s]]++;
            T.column[t] = i;
            T.value[t] = A.value[s];
        }
    return T;
}

namespace {

/// The columns of P at `row`, times `factor`.
void addRow(const SparseRows& P, int i, double factor, SparseRow& row) {
    for (int s = P.start[i]; s < P.start[i + 1]; ++s) row.add(P.column[s], factor * P.value[s]);
}

/// (L + D/2) P, L and D what A has below and on its diagonal.
SparseRows lowerProduct(const SparseRows& A, const SparseRows& P, int nColumns) {
    return rowByRow(A.n(), nColumns, [&](int i, SparseRow& row, SparseRows& Y) {
        int s = A.start[i];
        for (; A.column[s] < i; ++s) addRow(P, A.column[s], A.value[s], row);
        addRow(P, i, 0.5 * A.value[s], row);
        row.moveTo(Y);
    });
}

}  // namespace

SparseRows coarseMatrix(const SparseRows& A, const SparseRows& P, const SparseRows& R) {
    const int n = R.n();
    const SparseRows Y = lowerProduct(A, P, n);
    const SparseRows X = rowByRow(n, n, [&](int i, SparseRow& row, SparseRows& rows) {
        for (int s = R.start[i]; s < R.start[i + 1]; ++s) addRow(Y, R.column[s], R.value[s], row);
        row.moveTo(rows);
    });
    const SparseRows transpose = transposed(X, n);
    return rowByRow(n, n, [&](int i, SparseRow& row, SparseRows& rows) {
        addRow(X, i, 1, row);
        addRow(transpose, i, 1, row);
        row.sort();
        row.moveTo(rows);
    });
}

}  // namespace pfem
