#pragma once
// A mesh under construction, and the steps that end it whatever it was made from.

#include "mesher/mesher.hpp"

namespace pfem {

/// Nodes in any order; cells and patches refer to them.
struct Draft {
    Points<2> x, v;
    std::vector<double> h;
    Mesh<2> mesh;
};

int materialIndex(Mesh<2>& mesh, const std::string& name);

/// The patch of this name; a new one where there is none.
Patch<2>& patchNamed(Mesh<2>& mesh, const std::string& name);

/// Initial velocities along walls, numbering along Hilbert's curve, walls that move with nodes of their own, straight
/// walls with nodes that slide. `bodies`: where the cells of each body are.
State<2> finishMesh(Draft draft, const MeshDescription& description, const std::vector<MeshedBody>& bodies);

}  // namespace pfem
