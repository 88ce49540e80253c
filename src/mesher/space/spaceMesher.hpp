#pragma once
// From the description of bodies and walls in space to the state at time 0.

#include "mesh/foreignMesh.hpp"
#include "mesher/space/spaceDescription.hpp"
#include "state/state.hpp"

namespace pfem {

/// What became of a body.
struct SpaceMeshedBody {
    int first = 0, last = 0;  // its fluid or solid cells: first .. last-1
    double size = 0;          // wanted edge length [m]
    bool fluid = true;
};

struct SpaceMeshResult {
    State<3> state;
    std::vector<SpaceMeshedBody> bodies;
    std::vector<std::string> warnings;
};

/// Mesh all bodies and walls. Bodies that touch share their nodes. Points of walls are geometry: no cell has them;
/// fluid nodes on a wall know the first of its faces that they lie on (Nodes::wall). Nodes are numbered along Hilbert's
/// curve, those of walls behind them; ids 0 .. n-1; a = p = sigma = 0, x = X. On walls that are no openings the
/// velocity is the body's part along all of them; on an interface the solid's. Throws UserError with the place
/// in the dictionary.
SpaceMeshResult buildSpaceMesh(const SpaceDescription& description);

/// The same with the tetrahedra of a file: bodies, patches and walls are its groups, walls may be shapes, too. Points
/// at one place are joined. Nodes::h: mean length of the edges at the node. Throws UserError: no such group, flat or
/// overlapping tetrahedra.
SpaceMeshResult takeSpaceMesh(SpaceDescription description, const ForeignMeshOf<3>& file);

}  // namespace pfem
