#pragma once
// Cells of bodies on their way to a state: patches and walls are found by where faces lie. Internal to the mesher.

#include "mesher/space/spaceMesher.hpp"
#include "mesher/space/tetrahedra.hpp"

namespace pfem {

/// The state of bodies and walls. `cells`: their label is the body's number + 1; `h`: per node of it [m].
SpaceMeshResult finishSpaceMesh(const SpaceDescription& description, const Tetrahedra& cells,
                                const std::vector<double>& h);

/// The patches of walls and their points, behind all other nodes.
void addWalls(const SpaceDescription& description, State<3>& state, std::vector<std::string>& warnings);

/// Faces of a body's boundary that lie in the regions or in the box of a selection, outwards.
std::vector<Face<3>> selectedFaces(const SpaceDescription& description, const FaceSelection& selection,
                                   const Points<3>& x, const std::vector<Face<3>>& boundary);

/// The wanted size everywhere [m].
SizeAt sizeField(const SpaceDescription& description, const SpaceDomain& domain);

}  // namespace pfem
