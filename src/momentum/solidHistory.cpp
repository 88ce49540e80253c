#include "momentum/solidHistory.hpp"

#include <algorithm>

namespace pfem {

template <int Dim>
std::vector<std::string> historyNames(const Problem<Dim>& problem) {
    std::vector<std::string> names;
    for (const auto& material : problem.materials) {
        if (material.kind != MaterialKind::solid) continue;
        for (const auto& name : material.solid.law->historyNames())
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

std::vector<int> historyColumns(const SolidLaw& law, const std::vector<std::string>& names) {
    std::vector<int> columns;
    for (const auto& name : law.historyNames())
        columns.push_back(static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin()));
    return columns;
}

namespace {

/// Of each cell: the mean of its nodes.
template <int Dim>
History cellMeans(const Patches<Dim>& patches, const History& nodal) {
    History cell{nodal.names, {}};
    cell.resize(patches.nCells());
    for (int e = 0; e < patches.nCells(); ++e)
        for (int k = 0; k < nodal.width(); ++k)
            for (const int node : patches.cell(e)) cell.at(e, k) += nodal.at(node, k) / (Dim + 1);
    return cell;
}

/// At each node of the material: the mean of its patch.
template <int Dim>
History nodalMeans(const Patches<Dim>& patches, const History& cell) {
    const NodeToCells& around = *patches.around;
    History nodal{cell.names, {}};
    nodal.resize(patches.nNodes());
    for (int i = 0; i < patches.nNodes(); ++i)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            for (int k = 0; k < cell.width(); ++k)
                nodal.at(i, k) += patches.element[around.cell[s]].measure * cell.at(around.cell[s], k) /
                                  ((Dim + 1) * patches.volume[i]);
    return nodal;
}

}  // namespace

template <int Dim>
History historyAtPoints(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                        const History& nodal) {
    History history{historyNames<Dim>(problem), {}};
    if (history.empty()) return history;
    History stored = patches.scheme == Integration::nodal ? nodal
                     : cells.history.empty()              ? cellMeans<Dim>(patches, nodal)
                                                          : cells.history;
    if (stored.names == history.names) return stored;
    const int n = nStressPoints<Dim>(patches);
    history.resize(n);
    for (int p = 0; p < n; ++p) {
        if (!isStressPoint<Dim>(patches, p)) continue;
        const SolidLaw& law = *problem.solid(cells.material[cellOfPoint<Dim>(patches, p)]).law;
        const auto columns = historyColumns(law, history.names);
        const auto start = law.historyAtStart();
        for (std::size_t k = 0; k < columns.size(); ++k) history.at(p, columns[k]) = start[k];
        for (int k = 0; k < history.width(); ++k) {
            const auto at = std::find(stored.names.begin(), stored.names.end(), history.names[k]);
            if (at != stored.names.end()) history.at(p, k) = stored.at(p, static_cast<int>(at - stored.names.begin()));
        }
    }
    return history;
}

template <int Dim>
void storeHistory(const Patches<Dim>& patches, History point, History& nodal, History& cell) {
    if (patches.scheme == Integration::nodal) {
        nodal = std::move(point);
        cell = {};
    } else {
        nodal = nodalMeans<Dim>(patches, point);
        cell = std::move(point);
    }
}

template std::vector<std::string> historyNames<2>(const Problem<2>&);
template History historyAtPoints<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&, const History&);
template void storeHistory<2>(const Patches<2>&, History, History&, History&);

}  // namespace pfem
