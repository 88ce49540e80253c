#pragma once
// The keyword reference: every entry of every dictionary of a case, from the declarations that the programs
// read by.

#include <string>
#include <vector>

#include "dictionary/entries.hpp"

namespace pfem {

/// One dictionary or sub-dictionary.
struct KeywordTable {
    std::string file;   // "system/pfemSolution"
    std::string place;  // the sub-dictionary, "" for the dictionary itself
    std::string meaning;
    std::vector<EntryDescription> rows;
};

/// In the order of the page.
std::vector<KeywordTable> keywordTables();

/// The page doc/keywords.md.
std::string keywordPage();

// Its parts.
std::vector<KeywordTable> systemKeywords();     // controlDict, pfemSolution
std::vector<KeywordTable> functionKeywords();   // controlDict.functions, one table per type
std::vector<KeywordTable> meshKeywords();       // meshDict
std::vector<KeywordTable> spaceMeshKeywords();  // meshDict in three dimensions
std::vector<KeywordTable> sweepKeywords();      // sweepDict
std::vector<KeywordTable> constantKeywords();   // materials, g
std::vector<KeywordTable> conditionKeywords();  // boundaryConditions, by the types of patches

}  // namespace pfem
