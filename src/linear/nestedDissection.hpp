#pragma once
// An order of elimination from where the unknowns are.

#include <Eigen/Core>
#include <vector>

namespace pfem {

template <int Dim>
using Places = std::vector<Eigen::Matrix<double, Dim, 1>>;

/// Which unknowns meet in an entry of a matrix: those of i are neighbour[start[i]] ... neighbour[start[i + 1] - 1].
struct MatrixGraph {
    std::vector<int> start;  // n + 1
    std::vector<int> neighbour;
};

/// Unknowns first ... first + width - 1 of an order of elimination, which are eliminated together.
struct Piece {
    int first = 0;
    int width = 0;
    int nChildren = 0;  // pieces that this one parts; they come right before it, each after its own
};

struct Dissection {
    std::vector<int> order;  // of the unknowns
    std::vector<Piece> pieces;
};

/// Halves of equal number, cut across the direction in which they extend most; what of one half meets the other comes
/// last; the halves likewise, until they are small (George).
template <int Dim>
Dissection nestedDissection(const MatrixGraph& graph, const Places<Dim>& place);

}  // namespace pfem
