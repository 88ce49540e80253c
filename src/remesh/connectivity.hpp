#pragma once
// Which triangles of the new triangulation are fluid.

#include "remesh/controls.hpp"
#include "remesh/delaunay.hpp"
#include "remesh/movedMesh.hpp"
#include "state/volumeCauses.hpp"

namespace pfem {

/// A candidate's nodes with what the rules ask about them; new node indices.
template <int Dim>
struct CandidateNodes {
    Points<Dim> x;
    Points<Dim> v;
    std::vector<double> h;
    std::vector<unsigned char> onSolid;
    std::vector<unsigned char> wet;   // was in a fluid cell before
    std::vector<int> old;             // index in the moved old mesh, -1 for inserted nodes
    double dt = 0;                    // length of the step [s]
    std::vector<Supports<Dim>> wall;  // as Topology::supports
};

/// A cell that has become fluid or has ceased to be.
template <int Dim>
struct CellChange {
    VolumeCause cause;
    Simplex<Dim> cell;
    double amount = 0;  // its measure, negative when it has gone
};

template <int Dim>
struct Connectivity {
    std::vector<Simplex<Dim>> fluid;
    std::vector<Simplex<Dim>> gaps;        // cells of air, no larger than a contact may be, between surfaces or drops
    std::vector<CellChange<Dim>> changes;  // by `contact` outside the moved old mesh, by `stretched`, `released` inside
};

/// The cells of the changes by one cause.
template <int Dim>
std::vector<Simplex<Dim>> cellsOf(const std::vector<CellChange<Dim>>& changes, VolumeCause cause);

/// Inside the moved old mesh everything is fluid but for cells that walls cut; from its boundary, cells with a
/// circumradius above alphaInside alpha h, slivers and collapsing cells with a node of their own are peeled off, and a
/// solid's node carried by one cell is released when the fluid has come nearer to the other solid nodes. Outside, a
/// cell is a new contact and must be small, close and closing; one that is small alone is a gap.
template <int Dim>
Connectivity<Dim> selectFluid(const RemeshingControls& controls, const Triangulation<Dim>& triangulation,
                              const CandidateNodes<Dim>& nodes, const MovedMesh<Dim>& moved);

}  // namespace pfem
