#include "linear/saddle.hpp"

#include <algorithm>

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

/// One row while it is put together.
class Row {
public:
    explicit Row(int nColumns) : at_(nColumns, -1) {}

    void add(int column, double value) {
        if (at_[column] < 0) {
            at_[column] = static_cast<int>(entries_.size());
            entries_.emplace_back(column, 0.0);
        }
        entries_[at_[column]].second += value;
    }
    const std::vector<std::pair<int, double>>& sorted() {
        std::sort(entries_.begin(), entries_.end());
        return entries_;
    }
    void clear() {
        for (const auto& entry : entries_) at_[entry.first] = -1;
        entries_.clear();
    }

private:
    std::vector<int> at_;
    std::vector<std::pair<int, double>> entries_;
};

/// The same row at the end of another matrix.
void appendRow(const SparseRows& A, int i, SparseRows& to) {
    to.column.insert(to.column.end(), A.column.begin() + A.start[i], A.column.begin() + A.start[i + 1]);
    to.value.insert(to.value.end(), A.value.begin() + A.start[i], A.value.begin() + A.start[i + 1]);
    to.start.push_back(static_cast<int>(to.column.size()));
}

/// One matrix of blocks of rows.
SparseRows joined(const std::vector<SparseRows>& blocks) {
    struct Begin {
        int row = 0, entry = 0;
    };
    std::vector<Begin> begin(1);
    for (const SparseRows& block : blocks)
        begin.push_back({begin.back().row + block.n(), begin.back().entry + block.start.back()});
    SparseRows A;
    A.start.resize(static_cast<std::size_t>(begin.back().row) + 1);
    A.column.resize(begin.back().entry);
    A.value.resize(begin.back().entry);
    parallelTasks(static_cast<int>(blocks.size()), [&](int b) {
        const auto [row, entry] = begin[b];
        for (int i = 1; i <= blocks[b].n(); ++i) A.start[row + i] = entry + blocks[b].start[i];
        std::copy(blocks[b].column.begin(), blocks[b].column.end(), A.column.begin() + entry);
        std::copy(blocks[b].value.begin(), blocks[b].value.end(), A.value.begin() + entry);
    });
    return A;
}

}  // namespace

Eigen::VectorXd multiply(const SparseRows& A, const Eigen::VectorXd& x) {
    Eigen::VectorXd y(A.n());
    parallelFor(A.n(), [&](int i) {
        double sum = 0;
        for (int s = A.start[i]; s < A.start[i + 1]; ++s) sum += A.value[s] * x[A.column[s]];
        y[i] = sum;
    });
    return y;
}

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
    constexpr int block = 512;
    const int n = last - first, nBlocks = (n + block - 1) / block;
    const auto meetsVelocities = [&](int i) { return saddle.B.start[i] < saddle.B.start[i + 1]; };
    const auto forRow = [&](int i, Row& row) {
        const auto& [K, B, Bt] = std::tie(saddle.K, saddle.B, saddle.Bt);
        for (int s = K.start[i]; s < K.start[i + 1]; ++s) row.add(K.column[s], K.value[s]);
        for (int s = B.start[i]; s < B.start[i + 1]; ++s) {
            const int q = B.column[s];
            const double factor = B.value[s] * saddle.inverse[q];
            for (int t = Bt.start[q]; t < Bt.start[q + 1]; ++t) row.add(Bt.column[t], factor * Bt.value[t]);
        }
    };
    std::vector<SparseRows> part(nBlocks);
#pragma omp parallel if (n > shortLoop)
    {
        Row row(saddle.K.n());
#pragma omp for schedule(static)
        for (int b = 0; b < nBlocks; ++b)
            for (int i = first + b * block; i < std::min(last, first + (b + 1) * block); ++i) {
                if (!meetsVelocities(i)) {
                    appendRow(saddle.K, i, part[b]);
                    continue;
                }
                forRow(i, row);
                for (const auto& [column, value] : row.sorted()) {
                    part[b].column.push_back(column);
                    part[b].value.push_back(value);
                }
                part[b].start.push_back(static_cast<int>(part[b].column.size()));
                row.clear();
            }
    }
    return joined(part);
}

}  // namespace pfem
