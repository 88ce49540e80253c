#pragma once
// Patches that hold the same node, or the same rigid body, must move alike.

#include "conditions/problem.hpp"
#include "dictionary/dictionary.hpp"

namespace pfem {

/// Throws UserError at the motion of a patch, with both patches, the place and what to write: where walls, or clamped
/// edges, have a common node and do not move alike. `dict`: constant/boundaryConditions.
template <int Dim>
void checkMotions(const Dictionary& dict, const BoundaryConditions<Dim>& conditions, const State<Dim>& state);

/// The same where two clamped edges of one rigid body do not move alike, whether they meet or not.
template <int Dim>
void checkRigidMotions(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state);

}  // namespace pfem
