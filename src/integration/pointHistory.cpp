#include "integration/pointHistory.hpp"

namespace pfem {

namespace {

/// Of each cell: the mean of its nodes.
template <int Dim>
History cellMeans(const SmoothingDomains<Dim>& domains, const History& nodal) {
    History cell{nodal.names, {}};
    cell.resize(domains.nCells());
    for (int e = 0; e < domains.nCells(); ++e)
        for (int k = 0; k < nodal.width(); ++k)
            for (const int node : domains.cell(e)) cell.at(e, k) += nodal.at(node, k) / (Dim + 1);
    return cell;
}

/// At each node of the material: the mean of its patch.
template <int Dim>
History nodalMeans(const SmoothingDomains<Dim>& domains, const History& cell) {
    const NodeToCells& around = *domains.around;
    History nodal{cell.names, {}};
    nodal.resize(domains.nNodes());
    for (int i = 0; i < domains.nNodes(); ++i)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            for (int k = 0; k < cell.width(); ++k)
                nodal.at(i, k) += domains.element[around.cell[s]].measure * cell.at(around.cell[s], k) /
                                  ((Dim + 1) * domains.volume[i]);
    return nodal;
}

}  // namespace

template <int Dim>
History storedHistory(const SmoothingDomains<Dim>& domains, const History& nodal, const History& cell) {
    if (domains.scheme == Integration::nodal) return nodal;
    return cell.empty() ? cellMeans<Dim>(domains, nodal) : cell;
}

template <int Dim>
void storeHistory(const SmoothingDomains<Dim>& domains, History point, History& nodal, History& cell) {
    if (domains.scheme == Integration::nodal) {
        nodal = std::move(point);
        cell = {};
    } else {
        nodal = nodalMeans<Dim>(domains, point);
        cell = std::move(point);
    }
}

#define PFEM_INSTANTIATE(D)                                                                        \
    template History storedHistory<D>(const SmoothingDomains<D>&, const History&, const History&); \
    template void storeHistory<D>(const SmoothingDomains<D>&, History, History&, History&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
