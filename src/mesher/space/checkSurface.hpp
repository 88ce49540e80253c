#pragma once
// Surfaces of files as they are found: doubled points, turned triangles, holes, crossings, wrong units.

#include "mesher/space/spaceDescription.hpp"

namespace pfem {

/// Points at one place become one; triangles without area go.
void joinPoints(TriSurface& surface);

/// Divide the regions where faces include less than this angle [degrees], as OpenFOAM's surfaceFeatures: name_0, name_1
/// in the order of the file.
void splitRegions(TriSurface& surface, double includedAngle);

/// Turn the triangles alike, those of a closed surface outwards, and say whether it is closed.
/// Throws UserError with the place: edges of three triangles, triangles that cross.
void checkSurface(Geometry& geometry);

/// Edges with one triangle only, as places.
std::vector<std::array<Vec<3>, 2>> freeEdges(const TriSurface& surface);

/// "(0.1 0.2 0.3)"
std::string placeOf(const Vec<3>& x);

}  // namespace pfem
