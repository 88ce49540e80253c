#pragma once
// Periodic sides that the case does not fit.

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// Throws UserError at the entry of constant/periodic
///  - when its sides are nearer to each other than their bands are wide (state/unfolding.hpp),
///  - when the case has inlets or outlets, too,
///  - when nodes of solids are within the bands,
///  - when a wall on which fluid slides ends within them.
/// And when the state has images, but the case no periodic sides.
template <int Dim>
void checkPeriodic(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state);

}  // namespace pfem
