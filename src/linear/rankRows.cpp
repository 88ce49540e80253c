#include "linear/rankRows.hpp"

#include <algorithm>
#include <numeric>

#include "parallel/bisection.hpp"

namespace pfem {

Eigen::VectorXd RankRows::own(const Eigen::VectorXd& all) const {
    Eigen::VectorXd result(nRows());
    for (int row = begin(); row < end(); ++row) result[row - begin()] = all[order[row]];
    return result;
}

Eigen::VectorXd RankRows::all(const Eigen::VectorXd& own) const {
    const auto rows = ranks.gather(std::vector<double>(own.begin(), own.end()));
    Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t row = 0; row < rows.size(); ++row) result[order[row]] = rows[row];
    return result;
}

template <int Dim>
RankRows rankRows(const Ranks& ranks, const Places<Dim>& place, int n) {
    RankRows rows{ranks, {}, {}};
    if (ranks.isAlone()) return rows;
    rows.order.resize(n);
    std::iota(rows.order.begin(), rows.order.end(), 0);
    const std::vector<int> owner = bisect<Dim>(place, rows.order, ranks.size()).owner;
    std::stable_sort(rows.order.begin(), rows.order.end(), [&](int i, int j) { return owner[i] < owner[j]; });
    for (int rank = 0; rank <= ranks.size(); ++rank)
        rows.first.push_back(static_cast<int>(
            std::partition_point(rows.order.begin(), rows.order.end(), [&](int i) { return owner[i] < rank; }) -
            rows.order.begin()));
    return rows;
}

#define PFEM_INSTANTIATE(D) template RankRows rankRows<D>(const Ranks&, const Places<D>&, int);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
