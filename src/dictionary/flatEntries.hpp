#pragma once
// A dictionary as a flat list, to compare two of them.

#include <map>
#include <set>
#include <string>

#include "dictionary/dictionary.hpp"

namespace pfem {

/// The files in which the dictionary's entries stand: its own and those that it includes.
std::set<std::string> filesOf(const Dictionary& dictionary);

/// "convergence.tolU" -> "1e-4" for each entry at the end of the tree, macros and includes resolved, without the
/// FoamFile header; an empty sub-dictionary -> "{}"; a list of named dictionaries as if it were in braces.
std::map<std::string, std::string> flatEntries(const Dictionary& dictionary);

/// One line for each difference: "tolU: 1e-4 -> 1e-5", "tolP: 1e-4, not there before", "maxCo: removed (was 0.2)"; each
/// begins with `indent`.
std::string differences(const std::map<std::string, std::string>& before, const std::map<std::string, std::string>& now,
                        const std::string& indent = "    ");

}  // namespace pfem
