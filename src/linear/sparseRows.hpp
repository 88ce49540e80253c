#pragma once
// A sparse matrix by rows, put together row by row in threads.

#include <Eigen/Core>
#include <algorithm>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace pfem {

/// A sparse matrix by rows.
struct SparseRows {
    std::vector<int> start{0};
    std::vector<int> column;
    std::vector<double> value;

    int n() const { return static_cast<int>(start.size()) - 1; }

    /// Entries first ... last - 1 times x, four at a time: each addition waits for the one before.
    double product(int first, int last, const double* x) const {
        const int* const c = column.data();
        const double* const a = value.data();
        double sum = 0;
        int s = first;
        for (; s + 4 <= last; s += 4)
            sum += (a[s] * x[c[s]] + a[s + 1] * x[c[s + 1]]) + (a[s + 2] * x[c[s + 2]] + a[s + 3] * x[c[s + 3]]);
        for (; s < last; ++s) sum += a[s] * x[c[s]];
        return sum;
    }
    /// Of row i with x.
    double product(int i, const double* x) const { return product(start[i], start[i + 1], x); }
};

/// y = A x.
Eigen::VectorXd multiply(const SparseRows& A, const Eigen::VectorXd& x);

/// One row while it is put together.
class SparseRow {
public:
    explicit SparseRow(int nColumns) : at_(nColumns, -1) {}

    void add(int column, double value) {
        if (at_[column] < 0) {
            at_[column] = static_cast<int>(entries_.size());
            entries_.emplace_back(column, 0.0);
        }
        entries_[at_[column]].second += value;
    }
    void sort() {
        std::sort(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    }
    /// To the end of a matrix; then it is empty again.
    void moveTo(SparseRows& A) {
        for (const auto& [column, value] : entries_) {
            A.column.push_back(column);
            A.value.push_back(value);
            at_[column] = -1;
        }
        A.start.push_back(static_cast<int>(A.column.size()));
        entries_.clear();
    }

private:
    std::vector<int> at_;
    std::vector<std::pair<int, double>> entries_;
};

/// One matrix of blocks of rows.
SparseRows joined(const std::vector<SparseRows>& blocks);

/// The matrix whose row i of n append(i, row, A) puts at the end of A, by way of an empty `row` or without it.
template <class Append>
SparseRows rowByRow(int n, int nColumns, const Append& append) {
    constexpr int block = 256;
    const int nBlocks = (n + block - 1) / block;
    std::vector<SparseRows> part(nBlocks);
#pragma omp parallel if (nBlocks > 1)
    {
        SparseRow row(nColumns);
#pragma omp for schedule(static)
        for (int b = 0; b < nBlocks; ++b)
            for (int i = b * block; i < std::min(n, (b + 1) * block); ++i) append(i, row, part[b]);
    }
    return joined(part);
}

}  // namespace pfem
