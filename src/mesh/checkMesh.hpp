#pragma once
// Is a mesh sound, and what will the solver take for wall, interface and free surface?

#include <array>
#include <string>
#include <vector>

#include "mesh/topology.hpp"

namespace pfem {

/// Shape of the cells of one kind.
struct CellShapes {
    int inverted = 0;  // measure <= 0
    double worst = 1;  // smallest quality 2 r/R, in space 3 r/R (inradius, circumradius): 1 regular, 0 flat
    int worstCell = -1;
    std::array<int, 10> histogram{};  // of the quality, tenths
};

/// A place where something is wrong.
template <int Dim>
struct MeshFault {
    std::string what;
    Vec<Dim> where;
};

template <int Dim>
struct MeshCheck {
    CellShapes fluid, solid;
    std::vector<MeshFault<Dim>> faults;
    std::vector<MeshFault<Dim>> gaps;  // free surface along a wall or solid; while a run goes on, a contact to come
    double freeSurface = 0, wetWalls = 0, interface = 0;  // length or area of the fluid's faces [m, m2]
    int pieces = 0;                                       // of free surface that hang together
};

/// Faults: inverted cells; faces of more than two cells of a kind; nodes of cells that coincide (closer than
/// 1e-3 h) without being one. Gaps: free-surface faces whose nodes all lie nearer than 0.1 h to a wall or a
/// solid. `h`: per node.
template <int Dim>
MeshCheck<Dim> checkMesh(const Mesh<Dim>& mesh, const Topology<Dim>& topology, const Points<Dim>& x,
                         const std::vector<double>& h);

}  // namespace pfem
