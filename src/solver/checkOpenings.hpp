#pragma once
// Inlets whose water has no way to go, outlets whose level is below them.

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// Throws UserError at the entry of an outlet
///  - when its level is nowhere above its lower end,
/// of an inlet
///  - when the fluid neither has a free surface nor an outlet: it fills a closed box,
///  - when a wall is less than 2 h in front of it,
///  - in space, when no water wets it: nodes of a jet are made in the plane only.
template <int Dim>
void checkOpenings(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state);

}  // namespace pfem
