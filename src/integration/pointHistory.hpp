#pragma once
// Histories of laws at the stress points, and where they are stored.

#include "integration/stressPoints.hpp"

namespace pfem {

/// What is stored, at the stress points. `cell` is empty in states of a nodal run: then the means of the nodes.
template <int Dim>
History storedHistory(const SmoothingDomains<Dim>& domains, const History& nodal, const History& cell);

/// Store a history of the points: in `cell` what elements carry (empty for nodal), in `nodal` its value at the nodes.
template <int Dim>
void storeHistory(const SmoothingDomains<Dim>& domains, History point, History& nodal, History& cell);

}  // namespace pfem
