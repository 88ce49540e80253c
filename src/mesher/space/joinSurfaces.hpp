#pragma once
// Shapes that are meant to touch: round-off between them is taken away, gaps are refused.

#include "mesher/space/spaceDescription.hpp"

namespace pfem {

/// Shapes of bodies and walls that come within 1e-4 of `size` of each other touch: their points are moved onto planes
/// and corners of the shapes before them.
void joinSurfaces(SpaceDescription& description, double size);

/// Throws UserError where shapes run along each other at less than a tenth of `size` without touching, with the place.
void checkGaps(const SpaceDescription& description, double size);

}  // namespace pfem
