#include "linear/levels.hpp"

namespace pfem {

namespace {

/// The lower triangle.
SymmetricMatrix lowerTriangle(const SparseRows& A) {
    std::vector<std::vector<int>> rows(A.n());
    for (int j = 0; j < A.n(); ++j)
        for (int s = A.start[j]; s < A.start[j + 1]; ++s)
            if (A.column[s] > j) rows[j].push_back(A.column[s]);
    SymmetricMatrix lower = symmetricPattern(rows);
    for (int j = 0; j < A.n(); ++j)
        for (int s = A.start[j]; s < A.start[j + 1]; ++s)
            if (A.column[s] >= j) lower.add(A.column[s], j, A.value[s]);
    return lower;
}

}  // namespace

Levels::Levels(SparseRows A) : A_(std::move(A)) {
    constexpr int fewRows = 100;
    SparseRows coarse;
    const SparseRows* current = &A_;
    while (current->n() > fewRows) {
        const Aggregates joined = aggregates(*current);
        if (joined.count == 0 || 2 * joined.count > current->n()) break;
        Level level{BlockSweeps(*current), prolongation(*current, joined), {}};
        level.restriction = transposed(level.prolongation, joined.count);
        SparseRows next = coarseMatrix(*current, level.prolongation, level.restriction);
        levels_.push_back(std::move(level));
        coarse = std::move(next);
        current = &coarse;
    }
    SymmetricMatrix lower = lowerTriangle(*current);
    constexpr double little = 1e-12;  // no pivot vanishes where the pressure is known but for a constant
    for (int j = 0; j < lower.n; ++j) lower.value[lower.start[j]] *= 1 + little;
    factor_.analyse(lower);
    factor_.factor(lower);
}

Eigen::VectorXd Levels::cycle(const Eigen::VectorXd& b) const { return cycle(0, b); }

Eigen::VectorXd Levels::cycle(std::size_t level, const Eigen::VectorXd& b) const {
    if (level == levels_.size()) return factor_.solve(b);
    const SparseRows& P = levels_[level].prolongation;
    Eigen::VectorXd x(P.n()), r(P.n());
    levels_[level].sweeps.forward(b, x, r);
    const Eigen::VectorXd y = cycle(level + 1, multiply(levels_[level].restriction, r));
    parallelFor(P.n(), [&](int i) { x[i] += P.product(i, y.data()); });
    levels_[level].sweeps.backward(b, x, r);
    return x;
}

}  // namespace pfem
