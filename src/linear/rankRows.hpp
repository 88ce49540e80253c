#pragma once
// Which ranks have which rows of a matrix.

#include "linear/nestedDissection.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

/// Rows are numbered rank by rank, so that each rank has some in a row.
struct RankRows {
    Ranks ranks;             // that share the rows; one: it has them all, in their own order, and nothing below
    std::vector<int> order;  // the unknown of each row
    std::vector<int> first;  // first row of each rank, and after them the number of rows

    int begin() const { return first[ranks.rank()]; }
    int end() const { return first[ranks.rank() + 1]; }
    int nRows() const { return end() - begin(); }

    /// The numbers of own rows, from those of all unknowns, and the other way round (collective).
    Eigen::VectorXd own(const Eigen::VectorXd& all) const;
    Eigen::VectorXd all(const Eigen::VectorXd& own) const;
};

/// Equal numbers of the n first unknowns, those near to each other to one rank.
template <int Dim>
RankRows rankRows(const Ranks& ranks, const Places<Dim>& place, int n);

}  // namespace pfem
