#pragma once
// New connectivity of the fluid after its nodes have moved (Algorithm 1, line 13).

#include "remesh/controls.hpp"
#include "remesh/delaunay.hpp"
#include "remesh/movedMesh.hpp"

namespace pfem {

/// Is there a fluid triangle with a quality 4 sqrt(3) |e| / (sum of squared edges) (1: equilateral) below
/// `distortion`? Always true when that is 0: remesh every step.
bool isDistorted(double distortion, const Points<2>& x, const std::vector<Simplex<2>>& fluid);

struct NodeChanges {
    int removed = 0;
    int inserted = 0;
};

template <int Dim>
struct RemeshReport : NodeChanges {
    std::vector<Simplex<Dim>> contacts;  // cells that were accepted outside the moved old mesh
    std::vector<Simplex<Dim>> gaps;      // what may soon become one
};

/// Remove and insert nodes, triangulate with walls, solids and the free surface as constraints, select the fluid.
/// `topology`: of the state's mesh; `dt`: length of the step that moved it; `triangulator`: has the last triangulation,
/// or none. The volume's change by cause is added to state.ledger: "contact" (triangles accepted outside the moved old
/// mesh), "stretched" and "released" (peeled off inside it), "reshaped" (partly covered triangles, removed
/// surface nodes, overlaps), "isolated" (carried by particles without triangles), "gone" (with drops that are let go:
/// `gone`).
template <int Dim>
RemeshReport<Dim> remesh(const RemeshingControls& controls, const std::vector<PatchKind>& kinds, Topology<Dim> topology,
                         double dt, Triangulator& triangulator, State<Dim>& state, const std::vector<int>& gone = {});

/// The same when neither is at hand.
template <int Dim>
RemeshReport<Dim> remesh(const RemeshingControls& controls, const std::vector<PatchKind>& kinds, State<Dim>& state) {
    Triangulator triangulator;
    return remesh<Dim>(controls, kinds, makeTopology<Dim>(state.mesh, kinds, state.nodes.wall), state.time.deltaT,
                       triangulator, state);
}

}  // namespace pfem
