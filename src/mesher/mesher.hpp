#pragma once
// From the description of bodies and walls to the state at time 0.

#include "mesher/meshDescription.hpp"
#include "state/state.hpp"

namespace pfem {

struct MeshResult {
    State<2> state;
    std::vector<std::array<int, 2>> cellsOfBody;  // per body: first and last + 1 of its fluid or solid cells
    std::vector<std::string> warnings;
};

/// Mesh all bodies and walls. Bodies and walls that touch share their nodes; a wall has no face under a
/// solid. Nodes are numbered along Hilbert's curve, ids 0 .. n-1; a = p = sigma = 0, x = X.
/// On a wall the velocity is the body's part along the wall; on an interface the solid's.
/// Throws UserError with the place in the dictionary for geometry that cannot be meshed.
MeshResult buildMesh(const MeshDescription& mesh);

}  // namespace pfem
