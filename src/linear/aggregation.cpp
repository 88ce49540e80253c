#include "linear/aggregation.hpp"

#include <cmath>
#include <numeric>

namespace pfem {

namespace {

constexpr int none = -1;

/// Own rows and their neighbours among them.
struct OwnGraph {
    const SparseRows& A;
    int first;  // own row

    int n() const { return A.n(); }
    bool isOwn(int column) const { return column >= first && column < first + A.n(); }
    /// Calls visit(j, a) for each neighbour j of own row i, both numbered from the first own one.
    template <class Visit>
    void forNeighbours(int i, const Visit& visit) const {
        for (int s = A.start[i]; s < A.start[i + 1]; ++s)
            if (A.column[s] != first + i && A.value[s] != 0 && isOwn(A.column[s]))
                visit(A.column[s] - first, A.value[s]);
    }
    /// Does it meet no other row, whoever has it?
    bool isAlone(int i) const {
        for (int s = A.start[i]; s < A.start[i + 1]; ++s)
            if (A.column[s] != first + i && A.value[s] != 0) return false;
        return true;
    }
};

/// Rows none of whose neighbours is in an aggregate, with all of these.
void beginAggregates(const OwnGraph& graph, Aggregates& aggregates) {
    for (int i = 0; i < graph.n(); ++i) {
        bool isFree = aggregates.of[i] == none;
        if (isFree) graph.forNeighbours(i, [&](int j, double) { isFree = isFree && aggregates.of[j] == none; });
        if (!isFree || graph.isAlone(i)) continue;
        aggregates.of[i] = aggregates.count;
        graph.forNeighbours(i, [&](int j, double) { aggregates.of[j] = aggregates.count; });
        ++aggregates.count;
    }
}

/// The aggregate, of those there are in `of`, of the neighbour that row i is joined to most; -1 without any.
int nearest(const OwnGraph& graph, const std::vector<int>& of, int i) {
    double most = 0;
    int found = none;
    graph.forNeighbours(i, [&](int j, double a) {
        if (of[j] == none || std::abs(a) <= most) return;
        most = std::abs(a);
        found = of[j];
    });
    return found;
}

}  // namespace

Aggregates aggregates(const SparseRows& A, const RankRows& rows) {
    const OwnGraph graph{A, rows.begin()};
    Aggregates own{std::vector<int>(A.n(), none), 0};
    beginAggregates(graph, own);
    const std::vector<int> begun = own.of;
    parallelFor(A.n(), [&](int i) {
        if (begun[i] == none) own.of[i] = nearest(graph, begun, i);
    });
    if (rows.ranks.isAlone()) return own;
    const std::vector<int> counts = rows.ranks.gather(std::vector<int>{own.count});
    const int before = std::accumulate(counts.begin(), counts.begin() + rows.ranks.rank(), 0);
    for (int& aggregate : own.of)
        if (aggregate != none) aggregate += before;
    return {rows.ranks.gather(own.of), std::accumulate(counts.begin(), counts.end(), 0)};
}

SparseRows prolongation(const SparseRows& A, const Aggregates& aggregates, const RankRows& rows) {
    const std::vector<int>& of = aggregates.of;
    const int first = rows.begin();
    return rowByRow(A.n(), aggregates.count, [&](int i, SparseRow& row, SparseRows& P) {
        double sum = 0;
        for (int s = A.start[i]; s < A.start[i + 1]; ++s) sum += std::abs(A.value[s]);
        if (of[first + i] != none) row.add(of[first + i], 1);
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

/// (L + D/2) P, L and D what A has below and on its diagonal; own rows from those of all P.
SparseRows lowerProduct(const SparseRows& A, int first, const SparseRows& P, int nColumns) {
    return rowByRow(A.n(), nColumns, [&](int i, SparseRow& row, SparseRows& Y) {
        int s = A.start[i];
        for (; A.column[s] < first + i; ++s) addRow(P, A.column[s], A.value[s], row);
        addRow(P, first + i, 0.5 * A.value[s], row);
        row.moveTo(Y);
    });
}

/// Each rank's rows.
std::vector<SparseRows> ofRanks(SparseRows own, const Ranks& ranks) {
    if (ranks.isAlone()) return {std::move(own)};
    std::vector<std::size_t> rowEnds, entryEnds;
    const std::vector<int> starts = ranks.gather(own.start, rowEnds);
    const std::vector<int> columns = ranks.gather(own.column, entryEnds);
    const std::vector<double> values = ranks.gather(own.value);
    std::vector<SparseRows> rows(ranks.size());
    std::size_t row = 0, entry = 0;
    for (int rank = 0; rank < ranks.size(); ++rank) {
        rows[rank].start.assign(starts.begin() + row, starts.begin() + rowEnds[rank]);
        rows[rank].column.assign(columns.begin() + entry, columns.begin() + entryEnds[rank]);
        rows[rank].value.assign(values.begin() + entry, values.begin() + entryEnds[rank]);
        row = rowEnds[rank];
        entry = entryEnds[rank];
    }
    return rows;
}

}  // namespace

SparseRows coarseMatrix(const SparseRows& A, const SparseRows& P, const SparseRows& R, const RankRows& rows) {
    const int n = R.n();
    const bool isAlone = rows.ranks.isAlone();
    const SparseRows allP = isAlone ? SparseRows() : joined(ofRanks(P, rows.ranks));
    const SparseRows Y = lowerProduct(A, rows.begin(), isAlone ? P : allP, n);
    const std::vector<SparseRows> X = ofRanks(rowByRow(n, n,
                                                       [&](int i, SparseRow& row, SparseRows& sums) {
                                                           for (int s = R.start[i]; s < R.start[i + 1]; ++s)
                                                               addRow(Y, R.column[s], R.value[s], row);
                                                           row.moveTo(sums);
                                                       }),
                                              rows.ranks);
    std::vector<SparseRows> transposes;
    for (const SparseRows& part : X) transposes.push_back(transposed(part, n));
    return rowByRow(n, n, [&](int i, SparseRow& row, SparseRows& sums) {
        for (const SparseRows& part : X) addRow(part, i, 1, row);
        for (const SparseRows& part : transposes) addRow(part, i, 1, row);
        row.sort();
        row.moveTo(sums);
    });
}

}  // namespace pfem
