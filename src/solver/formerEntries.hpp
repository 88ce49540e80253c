#pragma once
// Entries of older cases that stand elsewhere now.

#include <string>

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// `stressUpdate` in system/pfemSolution, solid: paper and neoHookean give the materials of type hypoelastic the law
/// hypoelasticPaper or neoHookean. Returns what to write instead, empty when there is nothing to say.
template <int Dim>
std::string applyStressUpdate(const Dictionary& pfemSolution, Problem<Dim>& problem);

}  // namespace pfem
