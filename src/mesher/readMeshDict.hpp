#pragma once
// system/meshDict -> MeshDescription.

#include "dictionary/dictionary.hpp"
#include "mesher/meshDescription.hpp"

namespace pfem {

/// Read and check the words. `materials`: the names in constant/materials.
/// `meshSize` > 0 replaces the dictionary's default one; sizes of bodies, walls and refinements keep their ratio to it.
/// Throws UserError with file and line.
MeshDescription readMeshDict(const Dictionary& dict, const std::vector<std::string>& materials, double meshSize = 0);

}  // namespace pfem
