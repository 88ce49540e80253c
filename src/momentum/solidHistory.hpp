#pragma once
// What the laws of the solids remember, at the stress points.

#include "conditions/problem.hpp"
#include "integration/pointHistory.hpp"

namespace pfem {

/// Names of all that the laws of the case remember; each once.
template <int Dim>
std::vector<std::string> historyNames(const Problem<Dim>& problem);

/// The columns of a law's numbers in a history with these names.
std::vector<int> historyColumns(const SolidLaw& law, const std::vector<std::string>& names);

/// The stored history at the stress points; what is not stored there (yet) is as at the start. `cell` is empty in
/// states of a nodal run: then the means of the nodes.
template <int Dim>
History historyAtPoints(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                        const History& nodal);

}  // namespace pfem
