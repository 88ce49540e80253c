#pragma once
// Waves that the mesh cannot carry.

#include "dictionary/dictionary.hpp"
#include "state/state.hpp"

namespace pfem {

/// Sentences about entries of type waveMaker in constant/boundaryConditions whose waves (of a sea: those of its peak)
/// are shorter than eight mesh sizes of the fluid, the mean.
template <int Dim>
std::vector<std::string> doubtsAboutWaves(const Dictionary& conditions, const State<Dim>& state);

}  // namespace pfem
