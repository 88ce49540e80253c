#include "walls/penetration.hpp"

#include <limits>
#include <tuple>

#include "mesh/bins.hpp"
#include "mesh/distance.hpp"
#include "mesh/locator.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

using Edge = Face<2>;

/// Put node i at `distance` off the face on the side of n and stop its motion against n.
void putBack(const Edge& face, const Vec<2>& n, double distance, int i, Nodes<2>& nodes) {
    const auto& [x, v] = std::tie(nodes.x, nodes.v);
    const double s = nearestWeight<2>(x[face[0]], x[face[1]], x[i]);
    nodes.x[i] = x[face[0]] + s * (x[face[1]] - x[face[0]]) + distance * n;
    const Vec<2> surface = (1 - s) * v[face[0]] + s * v[face[1]];
    const double inward = (v[i] - surface).dot(n);
    if (inward < 0) nodes.v[i] -= inward * n;
}

}  // namespace

template <>
int returnPenetrating<2>(const Topology<2>& topology, double distance, State<2>& state) {
    if (state.mesh.solid.nodes.empty()) return 0;
    Nodes<2>& nodes = state.nodes;
    std::vector<Edge> faces;
    Points<2> ends;
    for (const auto& face : boundaryFaces<2>(state.mesh.solid.nodes, topology.solid)) {
        faces.push_back(face.nodes);
        for (const int node : face.nodes) ends.push_back(nodes.x[node]);
    }
    double hMax = 0;
    for (double h : nodes.h) hMax = std::max(hMax, h);
    Bins<2> bins(ends, 2 * hMax);
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
        bins.add(f, ends[2 * f].cwiseMin(ends[2 * f + 1]), ends[2 * f].cwiseMax(ends[2 * f + 1]));
    const Locator<2> solid(nodes.x, state.mesh.solid.nodes);

    int count = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        if (!topology.ofFluid(i) || !solid.contains(nodes.x[i])) continue;
        int nearest = -1;
        double best = std::numeric_limits<double>::max();
        bins.forEachNear(nodes.x[i], 2 * hMax, [&](int f) {
            const double d = distanceToFace<2>(nodes.x, faces[f], nodes.x[i]);
            if (d > best || (d == best && f > nearest)) return;  // of two at a common end the first
            best = d;
            nearest = f;
        });
        if (nearest < 0) continue;
        const Vec<2> n = faceArea<2>(nodes.x, faces[nearest]).normalized();  // out of the solid
        putBack(faces[nearest], n, distance * nodes.h[i], i, nodes);
        ++count;
    }
    return count;
}

}  // namespace pfem
