#pragma once
// Periodic sides that the case does not fit.

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// Throws UserError at the entry of constant/periodic
///  - when its sides are nearer to each other than their bands are wide (state/unfolding.hpp),
///  - when nodes of solids are within the bands,
///  - when a wall on which fluid slides, or an opening, ends within them,
///  - when an inlet has no water to begin with, or another speed at an image than at its master.
/// And when the state has images, but the case no periodic sides.
template <int Dim>
void checkPeriodic(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state);

}  // namespace pfem
