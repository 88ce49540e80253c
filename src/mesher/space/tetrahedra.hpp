#pragma once
// Tetrahedra in bodies of any shape: Delaunay refinement with protected edges (CGAL's Mesh_3).

#include <functional>

#include "mesher/space/spaceDomain.hpp"

namespace pfem {

struct Tetrahedra {
    Points<3> x;
    std::vector<Simplex<3>> cells;  // positively oriented
    std::vector<int> label;         // per cell, as SpaceDomain's
};

/// Wanted edge length at a place of these bodies (labels; 0: none) [m].
using SizeAt = std::function<double(const Vec<3>&, std::pair<int, int>)>;

/// Fill the bodies. `lines`: where surfaces meet at an edge; a closed one has its first point again at its end. Faces
/// between bodies are shared. The same input gives the same mesh. Throws UserError when that takes more than
/// `mostNodes` nodes: surfaces have details far finer than the size.
Tetrahedra fillBodies(const SpaceDomain& domain, const std::vector<Points<3>>& lines, const SizeAt& size,
                      double mostNodes);

}  // namespace pfem
