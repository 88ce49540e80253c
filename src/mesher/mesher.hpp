#pragma once
// From the description of bodies and walls to the state at time 0.

#include "mesher/meshDescription.hpp"
#include "state/state.hpp"

namespace pfem {

/// What became of a body.
struct MeshedBody {
    int first = 0, last = 0;  // its fluid or solid cells: first .. last-1
    double area = 0;          // of its polygon [m2]
    double perimeter = 0;     // [m]
    double size = 0;          // wanted edge length [m]
};

struct MeshResult {
    State<2> state;
    std::vector<MeshedBody> bodies;
    std::vector<std::string> warnings;
};

/// Mesh all bodies and walls. Bodies that touch share their nodes; a wall keeps its corners and ends only, the fluid's
/// nodes between them slide along it (Nodes::wall). A wall has no face under a named patch of a solid. Nodes are
/// numbered along Hilbert's curve, ids 0 .. n-1; a = p = sigma = 0, x = X. On a wall that is no opening the
/// velocity is the body's part along the wall; on an interface the solid's. Throws UserError with the place in the
/// dictionary for geometry that cannot be meshed.
MeshResult buildMesh(const MeshDescription& mesh);

}  // namespace pfem
