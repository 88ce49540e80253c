#pragma once
// Nodes are put onto openings.

#include <algorithm>

#include "mesh/simplex.hpp"
#include "mesh/topology.hpp"
#include "state/images.hpp"

namespace pfem {

/// Move the nodes to x. What cells change by has come or left: nodes do not lack it. Returns its sum over the cells
/// that count.
template <int Dim>
double moveNodes(Points<Dim> x, State<Dim>& state) {
    Nodes<Dim>& nodes = state.nodes;
    double sum = 0;
    const int nOwn = nOwnCells<Dim>(state);
    for (int e = 0; e < state.mesh.fluid.size(); ++e) {
        const auto& cell = state.mesh.fluid.nodes[e];
        if (std::all_of(cell.begin(), cell.end(), [&](int i) { return x[i] == nodes.x[i]; })) continue;
        const double change = simplexMeasure<Dim>(x, cell) - simplexMeasure<Dim>(nodes.x, cell);
        if (e < nOwn) sum += change;
        for (const int i : cell) nodes.lostVolume[i] += change / (Dim + 1);
    }
    nodes.x = std::move(x);
    return sum;
}

/// How far a point is before a wall's face.
template <int Dim>
double before(const Topology<Dim>& topology, int wall, const Points<Dim>& places, const Vec<Dim>& point) {
    const Face<Dim>& face = topology.walls[wall].nodes;
    return inwardNormal<Dim>(places, face).dot(point - places[face[0]]);
}

}  // namespace pfem
