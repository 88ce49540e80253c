#pragma once
// Which columns of a factor have one pattern and are eliminated together, and in what order.

#include <vector>

#include "linear/symmetricMatrix.hpp"

namespace pfem {

/// Columns first ... first + width - 1 (labels of the tree) that are eliminated as one dense block; what is below them
/// has one pattern.
struct Front {
    int first = 0;
    int width = 0;
    int rows = 0;      // where its rows start in EliminationTree::row
    int nRows = 0;
    int nChildren = 0; // fronts that leave their remainder to this one
};

/// The fronts in an order in which children come right before their parents, as on a stack. Labels count the unknowns
/// in the order of elimination, those that are not eliminated come last.
struct EliminationTree {
    std::vector<int> unknown;  // per label: index in the matrix
    std::vector<Front> fronts;
    std::vector<int> row;      // labels below the fronts' columns, ascending within each front

    const int* rowsOf(const Front& front) const { return row.data() + front.rows; }
};

/// The entries of a matrix by columns of labels; those between unknowns that are not eliminated are left out.
struct LabelledEntries {
    std::vector<int> start;  // per eliminated label: its entries, itself included
    std::vector<int> row;    // label
    std::vector<double> value;
};

/// What the elimination of a matrix begins with.
struct EliminationPlan {
    EliminationTree tree;
    LabelledEntries entries;
};

/// Fronts of the lower triangle A, of which all but the last nLast unknowns are eliminated. Neighbouring columns are
/// joined where that fills in few zeros: small dense blocks are quicker than thin ones.
EliminationPlan planElimination(const LowerRows& A, int nLast);

}  // namespace pfem
