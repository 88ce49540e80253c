#pragma once
// What the dictionaries said when a case was last run, so that a restart can tell what is different now.

#include <map>
#include <string>

#include "case/case.hpp"

namespace pfem {

using Settings = std::map<std::string, std::string>;  // "system/pfemSolution convergence.tolU" -> "1e-4"

/// All entries of the dictionaries that the solver reads. Throws UserError.
Settings currentSettings(const Case& theCase);

/// A line for each difference to what the last run has left in <case>/.pfemSettings; "" without one, and for the first
/// run. Throws UserError.
std::string settingChanges(const Case& theCase, const Settings& now);

/// Leave them for the next run. To be called when all have been accepted: after a mistake the next log then still
/// compares with the run that took place.
void keepSettings(const Case& theCase, const Settings& now);

}  // namespace pfem
