#include "linear/blockSweeps.hpp"

#include <cmath>
#include <cstdint>

namespace pfem {

BlockSweeps::BlockSweeps(const SparseRows& A) : diagonal_(A.n()), start_(A.n() + 1), meets_(), others_() {
    constexpr int leastRows = 500, mostBlocks = 8;
    const std::int64_t nBlocks = std::clamp(A.n() / leastRows, 1, mostBlocks);
    for (std::int64_t block = 1; block <= nBlocks; ++block)
        ends_.push_back(static_cast<int>(block * A.n() / nBlocks));
    std::vector<SparseRows> othersOf(size());
    std::vector<std::vector<int>> meets(size());
    parallelTasks(size(), [&](int block) {
        const int begin = first(block), end = ends_[block];
        for (int i = begin; i < end; ++i) {
            double added = 0, d = 0;
            for (int s = A.start[i]; s < A.start[i + 1]; ++s) {
                const int j = A.column[s];
                if (j == i) {
                    d = A.value[s];
                } else if (j >= begin && j < end) {
                    start_[i + 1] += j < i;
                } else {
                    added += 0.5 * std::abs(A.value[s]);
                    othersOf[block].column.push_back(j);
                    othersOf[block].value.push_back(A.value[s]);
                }
            }
            diagonal_[i] = {added, 1 / (d + added)};
            if (static_cast<int>(othersOf[block].column.size()) == othersOf[block].start.back()) continue;
            meets[block].push_back(i);
            othersOf[block].start.push_back(static_cast<int>(othersOf[block].column.size()));
        }
    });
    for (int i = 0; i < A.n(); ++i) start_[i + 1] += start_[i];
    column_.resize(start_.back());
    value_.resize(start_.back());
    parallelTasks(size(), [&](int block) {
        for (int i = first(block); i < ends_[block]; ++i) {
            int t = start_[i];
            for (int s = A.start[i]; A.column[s] < i; ++s) {
                if (A.column[s] < first(block)) continue;
                column_[t] = A.column[s];
                value_[t++] = static_cast<float>(A.value[s]);
            }
        }
    });
    for (const auto& rows : meets) meets_.insert(meets_.end(), rows.begin(), rows.end());
    others_ = joined(othersOf);
}

void BlockSweeps::forward(const Eigen::VectorXd& b, Eigen::VectorXd& x, Eigen::VectorXd& r) const {
    parallelTasks(size(), [&](int block) {
        for (int i = first(block); i < ends_[block]; ++i) {
            double sum = 0;
            for (int s = start_[i]; s < start_[i + 1]; ++s) sum += value_[s] * x[column_[s]];
            const double xi = x[i] = (b[i] - sum) * diagonal_[i].inverse;
            for (int s = start_[i]; s < start_[i + 1]; ++s) r[column_[s]] -= value_[s] * xi;
            r[i] = diagonal_[i].added * xi;
        }
    });
    parallelFor(static_cast<int>(meets_.size()), [&](int k) { r[meets_[k]] -= others_.product(k, x.data()); });
}

void BlockSweeps::backward(const Eigen::VectorXd& b, Eigen::VectorXd& x, Eigen::VectorXd& t) const {
    parallelFor(static_cast<int>(diagonal_.size()), [&](int i) { t[i] = b[i] + diagonal_[i].added * x[i]; });
    parallelFor(static_cast<int>(meets_.size()), [&](int k) { t[meets_[k]] -= others_.product(k, x.data()); });
    parallelTasks(size(), [&](int block) {
        for (int i = ends_[block]; i-- > first(block);) {
            double sum = 0;
            for (int s = start_[i]; s < start_[i + 1]; ++s) sum += value_[s] * x[column_[s]];
            const double xi = x[i] = (t[i] - sum) * diagonal_[i].inverse;
            for (int s = start_[i]; s < start_[i + 1]; ++s) t[column_[s]] -= value_[s] * xi;
        }
    });
}

}  // namespace pfem
