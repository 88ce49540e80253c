#pragma once
// What is refused, with the place in the dictionary and what to do about it. All throw UserError.

#include "mesher/region.hpp"

namespace pfem {

/// Sizes, loops, arcs and patches of single outlines.
void checkDescription(const MeshDescription& mesh);

/// An outline that runs back on itself, crosses or touches itself, naming its points. A wall may touch itself.
/// Only straight edges, or also the chords of arcs.
void checkShape(const MeshDescription& mesh, int outline, bool arcs = false);

/// More than 2e7 triangles: almost certainly a slip in meshSize or in the units.
void checkCount(const MeshDescription& mesh);

/// Outlines that cross.
void checkCrossings(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary);
bool crosses(const BoundaryNodes& boundary);

/// Outlines that come closer than a tenth of the size to others or themselves without touching.
void checkGaps(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary);

/// Edges that meet at an angle too sharp for a triangle.
void checkSpikes(const MeshDescription& mesh, const Arrangement& arrangement, const BoundaryNodes& boundary);

/// What is said of points that were merged with the one before, and of those that `simplify` has left out.
std::vector<std::string> mergedPoints(const MeshDescription& mesh, double tolerance);
std::vector<std::string> leftOutPoints(const MeshDescription& mesh, const Arrangement& whole,
                                       const std::vector<int>& leftOut);

/// Bodies inside each other, walls inside bodies, fluid on the right of a wall.
/// Returns warnings.
std::vector<std::string> checkRegions(const MeshDescription& mesh, const Arrangement& arrangement,
                                      const BoundaryNodes& boundary, const std::vector<Region>& regions);

}  // namespace pfem
