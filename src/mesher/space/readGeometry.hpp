#pragma once
// One entry of `geometry` in system/meshDict: a shape of OpenFOAM's, an extruded polygon, or a file.

#include <filesystem>

#include "mesher/space/spaceDescription.hpp"

namespace pfem {

/// `caseFolder`: files are looked for in its constant/triSurface. `meshSize`: facets of curved shapes are half of it
/// [m]. Throws UserError with the place in the dictionary or in the file.
Geometry readGeometry(const Dictionary& dict, const std::filesystem::path& caseFolder, double meshSize);

}  // namespace pfem
