#pragma once
// Where to look when not even the first step of a run can be computed.

#include <string>

#include "case/case.hpp"

namespace pfem {

/// The numbers that it depends on, a line each with file, line, entry and value: materials, gravity, motions and loads,
/// the time step, what system/pfemSolution sets other than by default, and system/meshDict.
std::string startNumbers(const Case& theCase);

}  // namespace pfem
