#pragma once
// What the dictionaries said when a case was last run, so that a restart can tell what is different now.

#include <map>
#include <string>

#include "case/case.hpp"

namespace pfem {

using Settings = std::map<std::string, std::string>;  // "system/pfemSolution convergence.tolU" -> "1e-4"

/// All entries of the dictionaries that the solver reads. Throws UserError.
Settings currentSettings(const Case& theCase);

/// Compares with what the last run has left in <case>/.pfemSettings and replaces that. Returns a line for each
/// difference; "" without one, and for the first run.
std::string rememberSettings(const Case& theCase, const Settings& now);

}  // namespace pfem
