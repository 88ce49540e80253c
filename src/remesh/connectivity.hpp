#pragma once
// Which triangles of the new triangulation are fluid.

#include "remesh/controls.hpp"
#include "remesh/delaunay.hpp"
#include "remesh/movedMesh.hpp"
#include "state/volumeCauses.hpp"

namespace pfem {

/// A candidate's nodes with what the rules ask about them; new node indices.
struct CandidateNodes {
    Points<2> x;
    Points<2> v;
    std::vector<double> h;
    std::vector<unsigned char> onSolid;
    std::vector<unsigned char> wet;  // was in a fluid cell before
    std::vector<int> old;            // index in the moved old mesh, -1 for inserted nodes
    double dt = 0;                   // length of the step [s]
    std::vector<Supports<2>> wall;   // as Topology::supports
};

/// A triangle that has become fluid or has ceased to be.
struct CellChange {
    VolumeCause cause;
    Simplex<2> cell;
    double amount = 0;  // its measure, negative when it has gone
};

struct Connectivity {
    std::vector<Simplex<2>> fluid;
    std::vector<Simplex<2>> gaps;     // triangles of air, no larger than a contact may be, between surfaces or drops
    std::vector<CellChange> changes;  // by `contact` outside the moved old mesh, by `stretched` and `released` inside
};

/// The cells of the changes by one cause.
std::vector<Simplex<2>> cellsOf(const std::vector<CellChange>& changes, VolumeCause cause);

/// Which cells of the moved old mesh, which must outlive it, hold a point.
struct MovedPlaces {
    Locator<2> fluid, solid;

    explicit MovedPlaces(const MovedMesh<2>& moved) : fluid(moved.x, moved.fluid), solid(moved.x, moved.solid) {}
};

/// Inside the moved old mesh everything is fluid; from its boundary, triangles with a circumradius above
/// alphaInside alpha h, slivers and collapsing triangles with a node of their own are peeled off, and a solid's node
/// carried by one triangle is released when the fluid has come nearer to the other solid node. Outside, a triangle is a
/// new contact and must be small, close and closing; one that is small alone is a gap.
Connectivity selectFluid(const RemeshingControls& controls, const Triangulation<2>& triangulation,
                         const CandidateNodes& nodes, const MovedMesh<2>& moved, const MovedPlaces& places);

}  // namespace pfem
