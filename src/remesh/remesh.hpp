#pragma once
// New connectivity of the fluid after its nodes have moved (Algorithm 1, line 13).

#include "remesh/controls.hpp"
#include "remesh/delaunay.hpp"
#include "remesh/movedMesh.hpp"
#include "state/unfolding.hpp"

namespace pfem {

/// Is there a fluid cell with a quality (1: equilateral) 4 sqrt(3) |e| / (sum of squared edges), 3D 12 (3 |e|)^(2/3) /
/// (sum of squared edges), below `distortion`? Always true when that is 0: remesh every step.
template <int Dim>
bool isDistorted(double distortion, const Points<Dim>& x, const std::vector<Simplex<Dim>>& fluid);

struct NodeChanges {
    int removed = 0;
    int inserted = 0;
};

template <int Dim>
struct RemeshReport : NodeChanges {
    std::vector<Simplex<Dim>> contacts;  // cells that were accepted outside the moved old mesh
    std::vector<Simplex<Dim>> gaps;      // what may soon become one
    Points<Dim> missing;                 // velocity, by `keepMomentum`: of the new nodes [m/s]; else empty
};

/// What a remeshing is to do.
template <int Dim>
struct RemeshTask {
    const RemeshingControls& controls;
    const std::vector<PatchKind>& kinds;
    Topology<Dim> topology;             // of the state's mesh
    double dt = 0;                      // length of the step that moved it [s]
    std::vector<int> gone = {};         // drops that are let go
    std::vector<int> pinched = {};      // nodes and drops for which there is no room any more
    const Sides<Dim>* sides = nullptr;  // periodic ones; the state is unfolded then, before and after
    std::vector<int> lips = {};         // nodes of the fluid that stay, whoever comes near
};

/// Remove and insert nodes, triangulate with walls, solids and the free surface as constraints, select the fluid.
/// `triangulator`: has the last triangulation, or none. The volume's change is booked in state.ledger: by `contact`
/// (triangles accepted outside the moved old mesh), `stretched` and `released` (peeled off inside it), `reshaped`
/// (partly covered triangles, removed surface nodes, overlaps), `isolated` (carried by particles without triangles),
/// `gone`.
template <int Dim>
RemeshReport<Dim> remesh(RemeshTask<Dim> task, Triangulator<Dim>& triangulator, State<Dim>& state);

/// The same when neither is at hand.
template <int Dim>
RemeshReport<Dim> remesh(const RemeshingControls& controls, const std::vector<PatchKind>& kinds, State<Dim>& state) {
    Triangulator<Dim> triangulator;
    return remesh<Dim>(
        {controls, kinds, makeTopology<Dim>(state.mesh, kinds, state.nodes.x, state.nodes.wall), state.time.deltaT},
        triangulator, state);
}

}  // namespace pfem
