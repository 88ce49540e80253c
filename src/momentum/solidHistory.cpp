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

template <int Dim>
History historyAtPoints(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                        const History& nodal) {
    History history{historyNames<Dim>(problem), {}};
    if (history.empty()) return history;
    History stored = storedHistory<Dim>(domains, nodal, cells.history);
    if (stored.names == history.names) return stored;
    const int n = nStressPoints<Dim>(domains);
    history.resize(n);
    for (int p = 0; p < n; ++p) {
        if (!isStressPoint<Dim>(domains, p)) continue;
        const SolidLaw& law = *problem.solid(cells.material[cellOfPoint<Dim>(domains, p)]).law;
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

#define PFEM_INSTANTIATE(D)                                               \
    template std::vector<std::string> historyNames<D>(const Problem<D>&); \
    template History historyAtPoints<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&, const History&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
