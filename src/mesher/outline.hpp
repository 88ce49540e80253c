#pragma once
// Questions to the description: curves, areas, sizes, names.

#include "mesher/curve.hpp"
#include "mesher/meshDescription.hpp"

namespace pfem {

/// The curve of edge `edge` of `outline`. Throws UserError for an arc through three points of one line.
Curve edgeCurve(const Outline& outline, int edge);

/// "body 'water'" or "wall 'tank'"; what its points are called: "vertices" or "points", also the keyword of the
/// dictionary.
std::string titleOf(const MeshDescription& mesh, int outline);
std::string pointsWord(const MeshDescription& mesh, int outline);

/// Points nearer than this are one: 1e-6 of the smallest size [m].
double mergeDistance(const MeshDescription& mesh);

/// The points that are not within `tolerance` of the one before; of a closed outline neither of the first.
std::vector<int> distinctPoints(const Outline& outline, double tolerance);

/// Names of the body's patches that edge `edge` belongs to.
std::vector<std::string> patchesOf(const Body& body, int edge);

/// Signed area of a closed outline, negative if it runs clockwise; arcs by 64 chords [m2].
double outlineArea(const Outline& outline);

/// Wanted edge length: the body's own, that of its cells, or the default [m].
double bodySize(const MeshDescription& mesh, const Body& body);

/// The cells of a structured body along its edges 0-1 and 1-2.
std::array<int, 2> patternCells(const MeshDescription& mesh, const Body& body);

/// Index of the body called `name`, -1 if there is none.
int bodyIndex(const MeshDescription& mesh, const std::string& name);

/// The outline of that index: bodies first, then walls.
const Outline& outlineOf(const MeshDescription& mesh, int index);

}  // namespace pfem
