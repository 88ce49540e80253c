#pragma once
// The rows of a gradient operator at all stress points, for matrices that are put together column by column.

#include <algorithm>

#include "base/parallel.hpp"
#include "integration/gradientRow.hpp"

namespace pfem {

/// The same domains with a stress point in each cell, whatever the scheme.
template <int Dim>
SmoothingDomains<Dim> pointsInCells(SmoothingDomains<Dim> domains) {
    domains.scheme = Integration::elemental;
    return domains;
}

/// The same domains with a stress point at each node.
template <int Dim>
SmoothingDomains<Dim> pointsAtNodes(SmoothingDomains<Dim> domains) {
    domains.scheme = Integration::nodal;
    return domains;
}

template <int Dim>
class PointRows {
public:
    /// `domains` must outlive the rows.
    explicit PointRows(const SmoothingDomains<Dim>& domains) : domains_(domains), rows_(nStressPoints<Dim>(domains)) {
        parallelFor(static_cast<int>(rows_.size()), [&](int p) {
            if (isStressPoint<Dim>(domains_, p)) rows_[p] = pointRow<Dim>(domains_, p);
        });
    }

    const GradientRow<Dim>& operator[](int p) const { return rows_[p]; }

    /// The stress points at which node i has a part, ascending: those of the cells around it, and with nodal
    /// integration the nodes of these.
    std::vector<int> pointsOf(int i) const {
        if (domains_.scheme == Integration::nodal) {
            std::vector<int> points = rows_[i].nodes;
            std::sort(points.begin(), points.end());
            return points;
        }
        const NodeToCells& around = *domains_.around;
        return {around.cell.begin() + around.start[i], around.cell.begin() + around.start[i + 1]};
    }

private:
    const SmoothingDomains<Dim>& domains_;
    std::vector<GradientRow<Dim>> rows_;
};

}  // namespace pfem
