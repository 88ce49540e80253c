#pragma once
// The cases of a study, in folders with their numbers as names, and the table of what they gave.

#include <filesystem>
#include <string>
#include <vector>

#include "study/runCase.hpp"
#include "study/sweep.hpp"

namespace pfem {

struct SweepCase {
    int number = 0;                   // from 1
    std::vector<std::string> values;  // of the parameters
    std::filesystem::path root;
    std::string name() const;  // "case 3"
};

/// The table of sweepDict as cases <folder>/<number>. Throws UserError.
std::vector<SweepCase> sweepCases(const Sweep& sweep, const std::filesystem::path& folder);

/// Names that the case does not have are found before anything runs: entries of parameters, functions of results.
/// Throws UserError.
void checkSweep(const Case& theCase, const Sweep& sweep);

/// Make the case, or compare it with what is there (study/caseCopy.hpp). With results its dictionaries may only differ
/// in endTime, stopAt, purgeWrite and runTimeModifiable.
void makeSweepCase(const Case& theCase, const Sweep& sweep, const SweepCase& one, Copying how);

/// How far a case has come, and its results: NaN while it is not finished and where a table has no value.
struct SweepRow {
    SweepCase theCase;
    Reached reached;
    std::vector<double> results;
};

/// Throws UserError for results that a finished case does not have.
std::vector<SweepRow> gather(const Sweep& sweep, const std::vector<SweepCase>& cases);

/// "case,<parameters>": comma separated values with a line of titles.
std::string casesTable(const Sweep& sweep, const std::vector<SweepCase>& cases);

/// "case,<parameters>,<results>,state": nothing between the commas where there is no value.
std::string resultsTable(const Sweep& sweep, const std::vector<SweepRow>& rows);

}  // namespace pfem
