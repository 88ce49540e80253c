#pragma once
// Which walls are openings: through those the first velocity of the water goes on, as it comes in and goes out in the
// run. With the part along them alone a stream would begin with a row of water at rest at its outlet.

#include <algorithm>

#include "conditions/patchType.hpp"

namespace pfem {

/// Does the entry of this wall in constant/boundaryConditions say that it is an opening? One that is missing or wrong
/// does not.
inline bool saysOpening(const Dictionary& conditions, const std::string& wall) {
    if (!conditions.found(wall) || !conditions.isDict(wall)) return false;
    const Dictionary& entry = conditions.subDict(wall);
    if (!entry.found("type")) return false;
    const auto name = entry.get<std::string>("type");
    return std::any_of(patchTypes().begin(), patchTypes().end(),
                       [&](const PatchType& type) { return type.name == name && type.kind == PatchKind::opening; });
}

/// Marks the walls of a description, plane or in space, that are openings.
template <class Description>
void markOpenings(const Dictionary& conditions, Description& description) {
    for (auto& wall : description.walls) wall.opening = saysOpening(conditions, wall.name);
}

}  // namespace pfem
