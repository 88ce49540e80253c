#pragma once
// Dictionaries as text, in the style of foamDictionary -expand.

#include <iosfwd>
#include <string>

#include "dictionary/dictionary.hpp"

namespace pfem {

/// All entries, macros and includes resolved: reading the text again gives the same dictionary.
void print(std::ostream& out, const Dictionary& dictionary, int indent = 0);

/// The entries on one line: "a 1; b { c 2; } ".
std::string oneLine(const Dictionary& dictionary);

/// The value of an entry as it would be written: "( 0 -9.81 0 )".
std::string valueText(const Dictionary& dictionary, const std::string& key);

}  // namespace pfem
