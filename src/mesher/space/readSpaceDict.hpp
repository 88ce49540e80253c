#pragma once
// system/meshDict of a case in space.

#include <filesystem>

#include "mesher/space/spaceDescription.hpp"

namespace pfem {

/// Of how many dimensions is the mesh that a meshDict asks for? `dimension 3;`, or bodies made of `geometry`; of a mesh
/// file what it holds.
int meshDimension(const Dictionary& dict, const std::filesystem::path& caseFolder);

/// `materials`: the names that bodies may have; `meshSize` > 0: instead of that at the top, to which the other sizes
/// keep their ratio. Throws UserError with the place in the dictionary.
SpaceDescription readSpaceDict(const Dictionary& dict, const std::vector<std::string>& materials,
                               const std::filesystem::path& caseFolder, double meshSize = 0);

}  // namespace pfem
