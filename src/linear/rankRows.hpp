#pragma once
// Which ranks have which rows of a matrix.

#include "linear/saddle.hpp"
#include "parallel/ranks.hpp"

namespace pfem {

/// Each rank has a run of the rows.
struct RankRows {
    Ranks ranks;                    // that share the rows; one has them all
    std::vector<std::size_t> ends;  // of each rank's run

    int begin() const { return ranks.isAlone() ? 0 : ranks.beginOf(ends); }
    int end(int n) const { return ranks.isAlone() ? n : static_cast<int>(ends[ranks.rank()]); }

    /// Numbers of all rows from those of own rows (collective).
    Eigen::VectorXd all(const Eigen::VectorXd& own) const;
};

}  // namespace pfem
