#pragma once
// What holdSizes of a meshDict says to the run: the places that keep their mesh sizes.

#include "mesher/meshDescription.hpp"
#include "mesher/space/spaceDescription.hpp"
#include "state/placeSizes.hpp"

namespace pfem {

/// Refinements and walls of an own, finer size; far away from them the size is that of the coarsest body of fluid.
/// Nothing where the sizes are not to be held.
PlaceSizes<2> heldSizes(const MeshDescription& mesh);

/// The same in space; what is near the surface of a moving wall follows it.
PlaceSizes<3> heldSizes(const SpaceDescription& mesh);

}  // namespace pfem
