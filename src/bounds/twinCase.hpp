#pragma once
// The computations behind a band: cases of their own, <folder>/<integration>-<mesh size>, inside the case.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace pfem {

struct TwinCase {
    std::string integration;  // nodal or elemental
    double h = 0;             // mesh size [m]
    std::filesystem::path root;
    std::string name() const;  // "nodal-0.006"
};

/// The twins of these mesh sizes, coarse to fine, nodal before elemental. Throws UserError for sizes that are
/// not positive or not different.
std::vector<TwinCase> twinCases(const Case& theCase, const std::string& folder, std::vector<double> sizes);

/// The mesh sizes for which `folder` holds both twins, coarse to fine.
std::vector<double> sizesIn(const std::filesystem::path& folder);

/// meshSize at the top of system/meshDict [m].
double meshSizeOf(const Case& theCase);

/// Write constant/ and system/ of the twin (study/caseCopy.hpp): those of the case with
///     pfemSolution    integration <nodal|elemental>; solids as the fluid
///     controlDict     startFrom latestTime;  and endTime where it is given.
/// A twin that has results must have been made from the same dictionaries (controlDict may change): else
/// UserError which names the file; with `overwrite` its folder is removed first.
void prepareTwin(const Case& theCase, const TwinCase& twin, std::optional<double> endTime, bool overwrite);

/// Number of triangles at the first time.
int countCells(const std::filesystem::path& root);

}  // namespace pfem
