#pragma once
// What each piece of a dissection leaves to the others when it is eliminated.

#include <vector>

#include "linear/nestedDissection.hpp"

namespace pfem {

/// Columns first ... first + width - 1 of a factor, eliminated as one dense block, and the rows below that it has.
struct Front {
    int first = 0;
    int width = 0;
    int rows = 0;  // where its rows start in Fronts::row
    int nRows = 0;
    int nChildren = 0;  // fronts that leave their remainder to this one
};

/// Children come right before their parents, as on a stack.
struct Fronts {
    std::vector<Front> front;
    std::vector<int> row;  // ascending within each front

    const int* rowsOf(const Front& each) const { return row.data() + each.rows; }
};

/// The lower triangle of a matrix by columns, in the order of elimination; rows in any order, itself included. The last
/// unknowns, which stay, have no columns.
struct LowerColumns {
    int n = 0;               // unknowns in all
    std::vector<int> start;  // of the columns, and the end
    std::vector<int> row;
    std::vector<double> value;

    int nColumns() const { return static_cast<int>(start.size()) - 1; }
};

/// Symbolic elimination: the rows of a front are those of its columns' entries and what its children leave.
Fronts makeFronts(const LowerColumns& A, const std::vector<Piece>& pieces);

}  // namespace pfem
