#pragma once
// The entry `functions` of controlDict, or of another dictionary.

#include <vector>

#include "dictionary/dictionary.hpp"

namespace pfem {

/// The functions of `functions { a {...} b {...} }` or `functions ( a {...} b {...} );`, each with its name in
/// keyword(). Throws UserError for what is no dictionary, has no name that a folder could have, or a name that another
/// has.
std::vector<Dictionary> functionEntries(const Dictionary& dict);

/// Of a function that is left out, no entry is reported as unused.
void takeAsRead(const Dictionary& entry);

/// Is `type` of a program other than this one? Words that are near to one of functionTypes() are taken for misspelt.
bool isForeignFunction(const Dictionary& entry);

}  // namespace pfem
