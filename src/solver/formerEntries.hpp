#pragma once
// Entries of older cases that stand elsewhere now.

#include <string>

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"
#include "remesh/controls.hpp"

namespace pfem {

/// `stressUpdate` in system/pfemSolution, solid: paper and neoHookean give the materials of type hypoelastic the law
/// hypoelasticPaper or neoHookean. Returns what to write instead, empty when there is nothing to say.
template <int Dim>
std::string applyStressUpdate(const Dictionary& pfemSolution, Problem<Dim>& problem);

/// Entries of `remeshing` that now stand in its sub-dictionary `expert` are still read where they stood. Returns what
/// to write now, nothing when there are none.
std::string takeFormerRemeshing(const Dictionary& pfemSolution, ExpertRemeshing& expert);

}  // namespace pfem
