#pragma once
// From the case's dictionaries to the problem and the controls.

#include <iostream>

#include "case/case.hpp"
#include "conditions/problem.hpp"
#include "solver/controls.hpp"

namespace pfem {

/// constant/materials, constant/g and constant/boundaryConditions for this state. Unused entries are named on
/// `warnings`, unless that is null.
/// Throws UserError, also for conditions that do not fit the mesh.
template <int Dim>
Problem<Dim> readProblem(const Case& theCase, const State<Dim>& state, std::ostream* warnings = &std::cerr);

/// system/pfemSolution; without the file an empty dictionary.
Dictionary pfemSolution(const Case& theCase);

/// What it says; without the file all defaults.
Controls readControls(const Case& theCase, std::ostream* warnings = &std::cerr);

}  // namespace pfem
