#pragma once
// Questions to the description: curves, areas, sizes, names.

#include "mesher/curve.hpp"
#include "mesher/meshDescription.hpp"

namespace pfem {

/// The curve of edge `edge` of `outline`. Throws UserError for an arc through three points of one line.
Curve edgeCurve(const Outline& outline, int edge);

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
