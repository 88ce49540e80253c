#include "linear/rankRows.hpp"

namespace pfem {

Eigen::VectorXd RankRows::all(const Eigen::VectorXd& own) const {
    if (ranks.isAlone()) return own;
    std::vector<double> rows(ends.back());
    std::copy(own.begin(), own.end(), rows.begin() + begin());
    ranks.complete(rows, ends);
    return Eigen::Map<const Eigen::VectorXd>(rows.data(), static_cast<Eigen::Index>(rows.size()));
}

Eigen::VectorXd RankRows::sum(const Eigen::VectorXd& mine) const {
    if (ranks.isAlone()) return mine;
    const std::vector<double> each = ranks.gather(std::vector<double>(mine.begin(), mine.end()));
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(mine.size());
    for (int rank = 0; rank < ranks.size(); ++rank)
        sum += Eigen::Map<const Eigen::VectorXd>(each.data() + rank * mine.size(), mine.size());
    return sum;
}

}  // namespace pfem
