#include "linear/sparseRows.hpp"

namespace pfem {

Eigen::VectorXd multiply(const SparseRows& A, const Eigen::VectorXd& x) {
    Eigen::VectorXd y(A.n());
    parallelFor(A.n(), [&](int i) { y[i] = A.product(i, x.data()); });
    return y;
}

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

}  // namespace pfem
