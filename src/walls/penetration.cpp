#include "walls/penetration.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "mesh/bins.hpp"
#include "mesh/locator.hpp"
#include "mesh/nearestOnFace.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// Put node i at `distance` off the face on the side of n and stop its motion against n.
template <int Dim>
void putBack(const Face<Dim>& face, const Vec<Dim>& n, double distance, int i, Nodes<Dim>& nodes) {
    const auto& [x, v] = std::tie(nodes.x, nodes.v);
    const Vec<Dim> w = nearestWeights<Dim>(x, face, x[i]), surface = weighted<Dim>(v, face, w);
    nodes.x[i] = weighted<Dim>(x, face, w) + distance * n;
    const double inward = (v[i] - surface).dot(n);
    if (inward < 0) nodes.v[i] -= inward * n;
}

/// Is there a wall before the face that a node would be put behind? It is left to squeezeOut, then.
template <int Dim>
bool isBlocked(const Topology<Dim>& topology, const Points<Dim>& x, const Vec<Dim>& from, const Vec<Dim>& n,
               double reach) {
    return std::any_of(topology.walls.begin(), topology.walls.end(), [&](const WallFace<Dim>& wall) {
        if (wall.patch < 0) return false;
        const Vec<Dim> inward = inwardNormal<Dim>(x, wall.nodes);
        const double before = inward.dot(from - x[wall.nodes[0]]);
        return inward.dot(n) < -0.5 && std::abs(before) < reach && before + reach * inward.dot(n) < 0 &&
               isWithin<Dim>(footWeights<Dim>(x, wall.nodes, from));
    });
}

/// Does the node share a cell with one of the face?
template <int Dim>
bool isBeside(const Topology<Dim>& topology, int i, const Face<Dim>& face) {
    const auto& ring = topology.ring;
    return std::any_of(face.begin(), face.end(), [&](int node) {
        return std::find(ring.node.begin() + ring.start[i], ring.node.begin() + ring.start[i + 1], node) !=
               ring.node.begin() + ring.start[i + 1];
    });
}

}  // namespace

template <int Dim>
Returned returnPenetrating(const Topology<Dim>& topology, double distance, State<Dim>& state) {
    if (state.mesh.solid.nodes.empty()) return {};
    Nodes<Dim>& nodes = state.nodes;
    std::vector<Face<Dim>> faces;
    Points<Dim> ends;
    for (const auto& face : topology.solidFaces) {
        if (topology.liesOnWall(face.nodes)) continue;  // behind it there is no fluid
        faces.push_back(face.nodes);
        for (const int node : face.nodes) ends.push_back(nodes.x[node]);
    }
    double hMax = 0;
    for (double h : nodes.h) hMax = std::max(hMax, h);
    Bins<Dim> bins(ends, 2 * hMax);
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
        Vec<Dim> low = ends[Dim * f], high = low;
        for (int k = 1; k < Dim; ++k) {
            low = low.cwiseMin(ends[Dim * f + k]).eval();
            high = high.cwiseMax(ends[Dim * f + k]).eval();
        }
        bins.add(f, low, high);
    }
    const Locator<Dim> solid(nodes.x, state.mesh.solid.nodes);

    Returned returned;
    for (int i = 0; i < nodes.size(); ++i) {
        if (!topology.ofFluid(i) || !solid.contains(nodes.x[i])) continue;
        const auto& own = nodes.wall[i];
        if (std::any_of(own.begin(), own.end(), [&](int w) { return w >= 0 && topology.isSkin(w); })) continue;
        int nearest = -1;
        double best = std::numeric_limits<double>::max();
        bins.forEachNear(nodes.x[i], 2 * hMax, [&](int f) {
            const double d = distanceToFace<Dim>(nodes.x, faces[f], nodes.x[i]);
            if (d > best || (d == best && f > nearest)) return;  // of two at a common end the first
            best = d;
            nearest = f;
        });
        if (nearest < 0) continue;
        const Vec<Dim> n = faceArea<Dim>(nodes.x, faces[nearest]).normalized();  // out of the solid
        if (isBlocked<Dim>(topology, nodes.x, nodes.x[i], n, best + distance * nodes.h[i])) continue;
        putBack<Dim>(faces[nearest], n, distance * nodes.h[i], i, nodes);
        ++returned.number;
        if (Dim == 3 && isBeside<Dim>(topology, i, faces[nearest])) returned.behind.push_back(i);
    }
    return returned;
}

template Returned returnPenetrating<2>(const Topology<2>&, double, State<2>&);
template Returned returnPenetrating<3>(const Topology<3>&, double, State<3>&);

}  // namespace pfem
