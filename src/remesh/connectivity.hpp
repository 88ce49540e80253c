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

/// How the new cells differ from those of the moved old mesh. In the plane its surface is kept, and the last two are
/// empty.
template <int Dim>
struct CellChanges {
    std::vector<CellChange<Dim>> changes;  // by `contact` outside the moved old mesh, by `stretched`, `released` inside
    std::vector<CellChange<Dim>> fresh;    // by `reshaped`, inside, of the fluid or let go: the old mesh had other cells
    std::vector<int> vanished;             // the old mesh's cells that are none of the triangulation's any more
};

template <int Dim>
struct Connectivity : CellChanges<Dim> {
    std::vector<Simplex<Dim>> fluid;
    std::vector<Simplex<Dim>> gaps;  // cells of air, no larger than a contact may be, between surfaces or drops
};

/// The cells of the changes by one cause.
template <int Dim>
std::vector<Simplex<Dim>> cellsOf(const std::vector<CellChange<Dim>>& changes, VolumeCause cause);

/// Inside the moved old mesh everything is fluid; from its boundary, cells with a circumradius above
/// alphaInside alpha h, slivers and collapsing cells with a node of their own are peeled off, and a solid's node
/// carried by one cell is released when the fluid has come nearer to the other solid nodes. Outside, a cell is a
/// new contact and must be small, close and closing; one that is small alone is a gap.
template <int Dim>
Connectivity<Dim> selectFluid(const RemeshingControls& controls, const Triangulation<Dim>& triangulation,
                              const CandidateNodes<Dim>& nodes, const MovedMesh<Dim>& moved);

}  // namespace pfem
