#pragma once
// Sums of the nodes over their cells, in one pass over the cells.

#include <omp.h>

#include <cstdint>

#include "integration/smoothingDomains.hpp"

namespace pfem {

/// cellOf(e) for the cells, and what it returns, give(k, node), for their nodes. A node gets what its cells give in
/// their order, as if it gathered from them, whatever the number of threads, each of which has a run of the nodes; but
/// the cells' numbers are read once, one after the other, instead of once for each node.
template <int Dim, class CellOf>
void sumAtNodes(const SmoothingDomains<Dim>& domains, const CellOf& cellOf) {
    const auto visit = [&](int e, const auto& isMine) {
        const Simplex<Dim>& cell = domains.cell(e);
        bool meets = false;
        for (const int node : cell) meets |= isMine(node);
        if (!meets) return;
        const auto give = cellOf(e);
        for (int k = 0; k <= Dim; ++k)
            if (isMine(cell[k])) give(k, cell[k]);
    };
    const Share& share = domains.share;
    if (!share.isWhole()) {  // nodes beyond the share keep what they have
        std::vector<unsigned char> marks(domains.nNodes(), 0);
        for (const int i : share.nodes()) marks[i] = 1;
        for (const int e : share.cells()) visit(e, [&](int node) { return marks[node] != 0; });
        return;
    }
    const int nCells = domains.nCells(), nRuns = nCells > shortLoop ? omp_get_max_threads() : 1;
    if (nRuns == 1) {
        for (int e = 0; e < nCells; ++e) visit(e, [](int) { return true; });
        return;
    }
    const std::vector<int>& start = domains.around->start;  // runs with equal numbers of cells around their nodes
    const auto end = [&](std::int64_t run) {
        const auto slot = static_cast<int>(run * start.back() / nRuns);
        return run == nRuns ? domains.nNodes()
                            : static_cast<int>(std::lower_bound(start.begin(), start.end(), slot) - start.begin());
    };
    parallelTasks(nRuns, [&](int run) {
        const int first = end(run), last = end(run + 1);
        for (int e = 0; e < nCells; ++e) visit(e, [&](int node) { return node >= first && node < last; });
    });
}

}  // namespace pfem
