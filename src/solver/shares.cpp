#include "solver/shares.hpp"

#include "integration/stressPoints.hpp"
#include "mesh/sharedTopology.hpp"

namespace pfem {

namespace {

/// Which have a mark, ascending.
std::vector<int> marked(const std::vector<unsigned char>& marks) {
    std::vector<int> list;
    for (int i = 0; i < static_cast<int>(marks.size()); ++i)
        if (marks[i]) list.push_back(i);
    return list;
}

/// The cells around nodes.
std::vector<int> cellsAround(const std::vector<int>& nodes, const NodeToCells& around, std::size_t nCells) {
    std::vector<unsigned char> marks(nCells, 0);
    for (const int i : nodes)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) marks[around.cell[s]] = 1;
    return marked(marks);
}

}  // namespace

template <int Dim>
Share partOf(const Ranks& ranks, int rank, std::vector<std::size_t> ends, const std::vector<Simplex<Dim>>& cells,
             const NodeToCells& around) {
    std::vector<unsigned char> marks(around.start.size() - 1, 0);
    for (std::size_t i = rank == 0 ? 0 : ends[rank - 1]; i < ends[rank]; ++i) marks[i] = 1;
    for (const int e : cellsAround(marked(marks), around, cells.size()))
        for (const int node : cells[e]) marks[node] = 1;
    auto nodes = marked(marks);
    auto ofNodes = cellsAround(nodes, around, cells.size());
    return {ranks, std::move(ends), std::move(nodes), std::move(ofNodes)};
}

template <int Dim>
Share shareOf(const Controls& controls, const std::vector<Simplex<Dim>>& cells, const NodeToCells& around) {
    const Ranks& ranks = controls.continuity.ranks;
    if (ranks.isAlone() || !mixesCells(controls.fluidScheme()) || controls.continuity.stabilisation == "bodyForce")
        return {};
    return partOf<Dim>(ranks, ranks.rank(), nodeRuns(ranks, around), cells, around);
}

#define PFEM_INSTANTIATE(D)                                                                               \
    template Share partOf<D>(const Ranks&, int, std::vector<std::size_t>, const std::vector<Simplex<D>>&, \
                             const NodeToCells&);                                                         \
    template Share shareOf<D>(const Controls&, const std::vector<Simplex<D>>&, const NodeToCells&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
