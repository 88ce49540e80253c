#pragma once
// Waves that the mesh cannot carry, and walls that give way to them before water of another depth.

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// Sentences about entries of type waveMaker in constant/boundaryConditions whose waves (of a sea: those of its peak)
/// are shorter than eight mesh sizes of the fluid, the mean; and about entries `absorb` whose depth is not that of the
/// water before the wall, to a twentieth.
template <int Dim>
std::vector<std::string> doubtsAboutWaves(const Dictionary& conditions, const Problem<Dim>& problem,
                                          const State<Dim>& state);

}  // namespace pfem
