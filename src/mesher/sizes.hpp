#pragma once
// Mesh sizes of a meshDict: one for all, and those of bodies, walls and refinements.

#include "dictionary/dictionary.hpp"

namespace pfem {

/// The entry `meshSize` of a dictionary, 0 where it has none [m]. Throws UserError for what is no length.
double readSize(const Dictionary& dict);

/// The radius of a sphere [m].
double readRadius(const Dictionary& dict);

/// The entry `holdSizes`. Throws UserError where the mesh is that of a file.
bool readHoldSizes(const Dictionary& dict);

/// Sizes of bodies, walls and refinements times `ratio`: they keep their ratio to the size for all where another one
/// than that of the dictionary is asked for (pfemMesh -h).
template <class Description>
void scaleSizes(double ratio, Description& mesh) {
    for (auto& body : mesh.bodies) body.meshSize *= ratio;
    for (auto& place : mesh.refinements) place.meshSize *= ratio;
    if constexpr (requires { mesh.walls.front().meshSize; })
        for (auto& wall : mesh.walls) wall.meshSize *= ratio;
}

}  // namespace pfem
