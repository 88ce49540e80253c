#pragma once
// Order of elimination from places in space.

#include <Eigen/Core>
#include <vector>

namespace pfem {

/// Which unknowns meet in an entry of the matrix: those of i are neighbour[start[i]] ... neighbour[start[i + 1] - 1].
struct MatrixGraph {
    std::vector<int> start;  // n + 1
    std::vector<int> neighbour;
};

/// Nested dissection: the unknowns of one half, those of the other, and last those of the first half that meet the
/// other; each half in the same way again. Of many, halves are taken
/// across the axis that leaves the fewest between them, of few across that along which they spread most. Cheaper than minimum
/// degree, with about its fill. Returns the unknowns in the order of elimination.
template <int Dim>
std::vector<int> nestedDissection(const MatrixGraph& graph, const std::vector<Eigen::Matrix<double, Dim, 1>>& place);

}  // namespace pfem
