#pragma once
// Sparse symmetric matrix, lower triangle by columns (rows ascending, diagonal first in each column).

#include <Eigen/Core>
#include <vector>

namespace pfem {

struct SymmetricMatrix {
    int n = 0;
    std::vector<int> start;  // n + 1
    std::vector<int> row;
    std::vector<double> value;

    /// Where entry (i, j), i >= j, is in `row` and `value`; it must be in the pattern.
    int slot(int i, int j) const;

    /// Add to entry (i, j) which must be in the pattern; the triangle is chosen here.
    void add(int i, int j, double amount);

    /// y = A x.
    Eigen::VectorXd multiply(const Eigen::VectorXd& x) const;
};

/// The pattern from the sorted lower rows of each column (each without the diagonal), values zero.
SymmetricMatrix symmetricPattern(const std::vector<std::vector<int>>& lowerRows);

}  // namespace pfem
