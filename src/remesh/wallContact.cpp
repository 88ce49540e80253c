#include "remesh/wallContact.hpp"

#include <cmath>

#include "mesh/simplex.hpp"
#include "remesh/movedMesh.hpp"

namespace pfem {

namespace {

/// A wall face as start, unit tangent, length and normal into the fluid.
struct Line {
    Vec<2> start, tangent, inward;
    double length;

    Line(const Points<2>& x, const Face<2>& face) : start(x[face[0]]), tangent(x[face[1]] - x[face[0]]) {
        length = tangent.norm();
        tangent /= length;
        inward = {-tangent[1], tangent[0]};  // fluid on the left
    }
    double along(const Vec<2>& p) const { return tangent.dot(p - start); }
    double distance(const Vec<2>& p) const { return inward.dot(p - start); }
};

void land(const Line& line, int w, int i, Nodes<2>& nodes) {
    nodes.x[i] = line.start + std::clamp(line.along(nodes.x[i]), 0.0, line.length) * line.tangent;
    nodes.v[i] = line.tangent * line.tangent.dot(nodes.v[i]);
    nodes.a[i] = line.tangent * line.tangent.dot(nodes.a[i]);
    nodes.wall[i] = w;
}

}  // namespace

bool isConcaveEnd(const Topology<2>& topology, const Points<2>& x, int w, bool atEnd) {
    const Line line(x, topology.walls[w].nodes);
    const int corner = topology.walls[w].nodes[atEnd ? 1 : 0];
    if (topology.onSolid[corner]) return true;
    for (int other = 0; other < static_cast<int>(topology.walls.size()); ++other) {
        const auto& face = topology.walls[other].nodes;
        if (other == w || topology.walls[other].patch < 0 || face[atEnd ? 0 : 1] != corner) continue;
        const Line next(x, face);
        return line.distance(next.start + 0.5 * next.length * next.tangent) > -1e-9 * next.length;
    }
    return false;
}

template <>
void landOnWalls<2>(const RemeshingControls& controls, const Topology<2>& topology, const Points<2>& xOld,
                    State<2>& state) {
    Nodes<2>& nodes = state.nodes;
    const double before = cellVolume<2>(nodes.x, state.mesh.fluid.nodes);
    for (int i = 0; i < nodes.size(); ++i) {
        if (topology.held(i) || nodes.wall[i] < 0) continue;
        const Line line(nodes.x, topology.walls[nodes.wall[i]].nodes);
        const double s = line.along(nodes.x[i]);
        if ((s < 0 || s > line.length) && !isConcaveEnd(topology, nodes.x, nodes.wall[i], s > 0))
            nodes.wall[i] = -1;
        else
            land(line, nodes.wall[i], i, nodes);  // also removes the round-off
    }
    for (int w = 0; w < static_cast<int>(topology.walls.size()); ++w) {
        if (topology.walls[w].patch < 0) continue;
        const Line line(nodes.x, topology.walls[w].nodes);
        for (int i = 0; i < nodes.size(); ++i) {
            if (topology.held(i) || topology.onWall[i] || nodes.wall[i] >= 0) continue;
            const double d = line.distance(nodes.x[i]);
            if (d > controls.landingDistance * nodes.h[i]) continue;
            const double dOld = line.distance(xOld[i]);
            if (dOld < -1e-9 * nodes.h[i] || d >= dOld) continue;  // was behind, or leaves
            const double s = line.along(nodes.x[i]);
            if (s >= 0 && s <= line.length) land(line, w, i, nodes);
        }
    }
    state.ledger["landed"] += cellVolume<2>(nodes.x, state.mesh.fluid.nodes) - before;
}

template <>
void releaseFromWalls<2>(const RemeshingControls& controls, const Topology<2>& topology, const Vec<2>& gravity,
                         double rho, Nodes<2>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        if (nodes.wall[i] < 0) continue;
        const Line line(nodes.x, topology.walls[nodes.wall[i]].nodes);
        const double scale = rho * (gravity.norm() * nodes.h[i] + 0.5 * nodes.v[i].squaredNorm());
        const bool pulledOff = topology.isolated(i) && gravity.dot(line.inward) > 0;
        if (!pulledOff && !(topology.freeSurface[i] && -nodes.p[i] > controls.wallTension * scale)) continue;
        nodes.wall[i] = -1;
        nodes.p[i] = 0;
        nodes.x[i] += 1e-3 * nodes.h[i] * line.inward;
    }
}

}  // namespace pfem
