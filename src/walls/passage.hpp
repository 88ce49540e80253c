#pragma once
// How water comes to openings and is put onto them.

#include <algorithm>

#include "mesh/onFace.hpp"
#include "mesh/simplex.hpp"
#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Move the nodes to x. What cells change by has come or left: nodes do not lack it. Returns its sum.
template <int Dim>
double moveNodes(Points<Dim> x, State<Dim>& state) {
    Nodes<Dim>& nodes = state.nodes;
    double sum = 0;
    for (const auto& cell : state.mesh.fluid.nodes) {
        if (std::all_of(cell.begin(), cell.end(), [&](int i) { return x[i] == nodes.x[i]; })) continue;
        const double change = simplexMeasure<Dim>(x, cell) - simplexMeasure<Dim>(nodes.x, cell);
        sum += change;
        for (const int i : cell) nodes.lostVolume[i] += change / (Dim + 1);
    }
    nodes.x = std::move(x);
    return sum;
}

/// Places of all nodes before and after the step.
template <int Dim>
struct Way {
    const Points<Dim>&from, &to;
};

/// How far a point is before a wall's face.
template <int Dim>
double before(const Topology<Dim>& topology, int wall, const Points<Dim>& places, const Vec<Dim>& point) {
    const Face<Dim>& face = topology.walls[wall].nodes;
    return inwardNormal<Dim>(places, face).dot(point - places[face[0]]);
}

/// The first of the wanted faces of walls that node i comes to: it crossed it, or is nearer than `distance` and
/// approaches; -1: none.
template <int Dim, class Wanted>
int arrivesAt(const Topology<Dim>& topology, const Way<Dim>& way, int i, double distance, const Wanted& wanted) {
    for (int w = 0; w < static_cast<int>(topology.walls.size()); ++w) {
        if (topology.walls[w].patch < 0 || !wanted(w)) continue;
        const double now = before<Dim>(topology, w, way.to, way.to[i]),
                     then = before<Dim>(topology, w, way.from, way.from[i]);
        if (now > distance || then < -1e-7 * distance || now >= then) continue;
        const double part = now < 0 && then > 0 ? then / (then - now) : 1;
        const Vec<Dim> place = way.from[i] + part * (way.to[i] - way.from[i]);
        if (footWeights<Dim>(way.to, topology.walls[w].nodes, place).minCoeff() > -1e-6) return w;
    }
    return -1;
}

}  // namespace pfem
