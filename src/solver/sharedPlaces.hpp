#pragma once
// Places that two hold: where edges of solids, solids, walls and openings meet, and what is done there.

#include <string>
#include <vector>

#include "conditions/boundaryConditions.hpp"
#include "state/state.hpp"

namespace pfem {

/// Two that meet at nodes of solids.
template <int Dim>
struct SharedPlace {
    std::string first, second;  // "'foot' (clamped)", "solid 'rubber'"
    Vec<Dim> at;                // the first of the nodes
    int count = 1;              // of the nodes
    std::string done;           // what the solver does there, and what to write if that is not meant
};

/// Of each two that meet somewhere, in the order of the nodes. `contact`: do solids meet walls (constant/contact)?
template <int Dim>
std::vector<SharedPlace<Dim>> sharedPlaces(const BoundaryConditions<Dim>& conditions, bool contact,
                                           const State<Dim>& state);

/// The same in a line each, under a heading; empty where nothing is shared.
template <int Dim>
std::string sharedPlacesText(const BoundaryConditions<Dim>& conditions, bool contact, const State<Dim>& state);

}  // namespace pfem
