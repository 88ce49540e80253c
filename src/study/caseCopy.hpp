#pragma once
// Cases of a study: a case's dictionaries with changes, in a folder of its own.

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "dictionary/overlay.hpp"

namespace pfem {

/// Another value of one entry. `file`: relative to the case; `path`: the dictionaries around it, outermost first, and
/// its keyword; `value`: as it is written in a dictionary.
struct Change {
    std::filesystem::path file;
    std::vector<std::string> path;
    std::string value;
};

/// The texts of the files that the changes concern, macros that follow from them not yet resolved; a file that is not
/// there is empty. Throws UserError.
Overlay changedTexts(const std::filesystem::path& root, const std::vector<Change>& changes);

struct CaseCopy {
    std::filesystem::path root;
    std::vector<Change> changes;
    /// Entries of controlDict that may differ from those of a copy with results; without any: all.
    std::vector<std::string> freeControls;
};

enum class Copying { keep, overwrite, compareOnly };

/// Write constant/ and system/ of the copy: those of the case with the changes, then macros and includes resolved, and
/// in controlDict `startFrom latestTime`. Files that are no dictionaries are copied; system/sweepDict is left out. A
/// copy that has results must have been made from the same dictionaries: else UserError which names file and entries.
/// overwrite: remove its folder first; compareOnly: write nothing, only throw.
void makeCopy(const Case& theCase, const CaseCopy& copy, Copying how = Copying::keep);

/// The files, relative to the case, from which a copy's dictionaries come: constant/, system/ and what they include
/// from inside the case.
std::vector<std::filesystem::path> sourcesOf(const Case& theCase);

}  // namespace pfem
