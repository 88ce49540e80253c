#include "linear/symmetricMatrix.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace pfem {

int SymmetricMatrix::slot(int i, int j) const {
    const auto begin = row.begin() + start[j];
    const auto end = row.begin() + start[j + 1];
    const auto found = std::lower_bound(begin, end, i);
    if (found == end || *found != i) throw InternalError("SymmetricMatrix: entry outside the pattern");
    return static_cast<int>(found - row.begin());
}

void SymmetricMatrix::add(int i, int j, double amount) { value[slot(std::max(i, j), std::min(i, j))] += amount; }

Eigen::VectorXd SymmetricMatrix::multiply(const Eigen::VectorXd& x) const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
    for (int j = 0; j < n; ++j)
        for (int s = start[j]; s < start[j + 1]; ++s) {
            const int i = row[s];
            y[i] += value[s] * x[j];
            if (i != j) y[j] += value[s] * x[i];
        }
    return y;
}

SymmetricMatrix symmetricPattern(const std::vector<std::vector<int>>& lowerRows) {
    SymmetricMatrix A;
    A.n = static_cast<int>(lowerRows.size());
    A.start.assign(lowerRows.size() + 1, 0);
    for (int j = 0; j < A.n; ++j) {
        A.row.push_back(j);
        A.row.insert(A.row.end(), lowerRows[j].begin(), lowerRows[j].end());
        A.start[j + 1] = static_cast<int>(A.row.size());
    }
    A.value.assign(A.row.size(), 0.0);
    return A;
}

}  // namespace pfem
