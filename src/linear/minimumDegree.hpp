#pragma once
// Orders of elimination with little fill.

#include <vector>

namespace pfem {

/// Which unknowns meet in an entry of a matrix: those of i are neighbour[start[i]] ... neighbour[start[i + 1] - 1].
struct MatrixGraph {
    std::vector<int> start;  // n + 1
    std::vector<int> neighbour;
};

/// The unknowns in an order of elimination with little fill (CHOLMOD's approximate minimum degree).
/// Throws StepFailure when memory runs out.
std::vector<int> minimumDegree(const MatrixGraph& graph);

}  // namespace pfem
