#pragma once
// What is refused of a description in space, with the place in the dictionary. All throw UserError.

#include "mesher/space/spaceDescription.hpp"
#include "mesher/space/tetrahedra.hpp"

namespace pfem {

/// Bodies of open surfaces, sizes, the number of cells, names used twice. Returns warnings: lengths in millimetres.
std::vector<std::string> checkSpace(const SpaceDescription& description);

/// Bodies without cells, and bodies that lie in each other.
void checkFilled(const SpaceDescription& description, const SpaceDomain& domain, const Tetrahedra& cells);

}  // namespace pfem
