#pragma once
// Is a mesh sound, and what will the solver take for wall, interface and free surface?

#include <array>
#include <string>
#include <vector>

#include "mesh/topology.hpp"

namespace pfem {

/// Shape of the cells of one kind.
struct CellShapes {
    int inverted = 0;  // area <= 0
    double worst = 1;  // smallest quality 2 r/R (inradius, circumradius): 1 equilateral, 0 flat
    int worstCell = -1;
    std::array<int, 10> histogram{};  // of the quality, tenths
};

/// A place where something is wrong.
struct MeshFault {
    std::string what;
    Vec<2> where;
};

struct MeshCheck {
    CellShapes fluid, solid;
    std::vector<MeshFault> faults;
    std::vector<MeshFault> gaps;  // free surface along a wall or solid; while a run goes on, a contact to come
    double freeSurface = 0, wetWalls = 0, interface = 0;  // length of the fluid's faces [m]
    int pieces = 0;                                       // of free surface that hang together
};

/// Faults: inverted cells; edges of more than two cells of a kind; nodes of cells that coincide (closer than
/// 1e-3 h) without being one. Gaps: free-surface faces whose nodes both lie nearer than 0.1 h to a wall or a
/// solid. `h`: per node.
MeshCheck checkMesh(const Mesh<2>& mesh, const Topology<2>& topology, const Points<2>& x, const std::vector<double>& h);

}  // namespace pfem
