#pragma once
// What is refused, with the place in the dictionary and what to do about it. All throw UserError.

#include "mesher/region.hpp"

namespace pfem {

/// Sizes, loops, arcs and patches of single outlines.
void checkDescription(const MeshDescription& mesh);

/// More than 2e7 triangles: almost certainly a slip in meshSize or in the units.
void checkCount(const MeshDescription& mesh);

/// Outlines that cross, or come closer than a tenth of the size without touching.
void checkBoundary(const MeshDescription& mesh, const Arrangement& arrangement,
                   const BoundaryNodes& boundary);

/// Bodies inside each other, walls inside bodies, fluid on the right of a wall.
/// Returns warnings.
std::vector<std::string> checkRegions(const MeshDescription& mesh, const Arrangement& arrangement,
                                      const BoundaryNodes& boundary, const std::vector<Region>& regions);

}  // namespace pfem
