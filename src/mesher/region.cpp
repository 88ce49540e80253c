#include "mesher/region.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesher/counts.hpp"

namespace pfem {

double Region::area() const {
    double twice = 0;
    for (const auto& [a, b] : edges) {
        const Vec<2> u = x[a] - x[0], w = x[b] - x[0];
        twice += u.x() * w.y() - u.y() * w.x();
    }
    return 0.5 * twice;
}

double Region::perimeter() const {
    double sum = 0;
    for (const auto& [a, b] : edges) sum += (x[b] - x[a]).norm();
    return sum;
}

bool Region::contains(const Vec<2>& point) const {
    bool inside = false;
    for (const auto& [a, b] : edges) {
        const Vec<2>&p = x[a], &q = x[b];
        if ((p.y() > point.y()) == (q.y() > point.y())) continue;
        if (point.x() < p.x() + (point.y() - p.y()) / (q.y() - p.y()) * (q.x() - p.x())) inside = !inside;
    }
    return inside;
}

Vec<2> Region::probe() const {
    const Vec<2> d = x[edges[0][1]] - x[edges[0][0]];
    return x[edges[0][0]] + 0.5 * d + 1e-4 * Vec<2>(-d.y(), d.x());
}

namespace {

/// An edge between two boundary nodes.
struct LoopEdge {
    Face<2> nodes;
    int piece;
};

/// The edges of a body's outline or, backwards, of a hole's, in their order.
std::vector<LoopEdge> loopOf(int outline, bool backward, const Arrangement& arrangement,
                             const BoundaryNodes& boundary) {
    std::vector<LoopEdge> loop;
    for (const auto& ref : arrangement.chains[outline]) {
        std::vector<int> chain = boundary.ofPiece[ref.piece];
        if (!ref.forward) std::reverse(chain.begin(), chain.end());
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) loop.push_back({{chain[i], chain[i + 1]}, ref.piece});
    }
    if (!backward) return loop;
    std::reverse(loop.begin(), loop.end());
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());  // the loop closes with its last edge
    for (auto& edge : loop) std::swap(edge.nodes[0], edge.nodes[1]);
    return loop;
}

/// Those of a body's edges that bound it.
std::vector<LoopEdge> boundaryOf(const MeshDescription& mesh, int body, const Arrangement& arrangement,
                                 const BoundaryNodes& boundary) {
    std::vector<LoopEdge> edges;
    const auto add = [&](const std::vector<LoopEdge>& loop, bool rim) {
        for (const auto& edge : loop)
            if (arrangement.bounds(edge.piece, body, rim)) edges.push_back(edge);
    };
    add(loopOf(body, false, arrangement, boundary), false);
    for (const auto& name : mesh.bodies[body].holes)
        add(loopOf(bodyIndex(mesh, name), true, arrangement, boundary), true);
    return edges;
}

/// Points and edges of the region; each point once.
void addEdges(Region& region, const std::vector<LoopEdge>& edges, const Arrangement& arrangement,
              const BoundaryNodes& boundary) {
    std::map<int, int> local;  // of the boundary's nodes
    for (const auto& edge : edges) {
        const int node = edge.nodes[0];
        if (!local.emplace(node, static_cast<int>(region.x.size())).second) continue;
        region.x.push_back(boundary.x[node]);
        region.boundaryNode.push_back(node);
    }
    region.nBoundary = static_cast<int>(region.x.size());
    for (const auto& edge : edges) {
        region.edges.push_back({local.at(edge.nodes[0]), local.at(edge.nodes[1])});
        const auto& uses = arrangement.pieces[edge.piece].uses;
        region.onWall.push_back(
            std::any_of(uses.begin(), uses.end(), [&](const auto& use) { return arrangement.isWall(use); }));
    }
}

}  // namespace

Region outlineRegion(int body, const Arrangement& arrangement, const BoundaryNodes& boundary) {
    Region region;
    addEdges(region, loopOf(body, false, arrangement, boundary), arrangement, boundary);
    return region;
}

Region regionOf(const MeshDescription& mesh, int body, const Arrangement& arrangement, const BoundaryNodes& boundary) {
    const Body& description = mesh.bodies[body];
    Region region;
    region.fluid = description.type == BodyType::fluid;
    region.h = bodySize(mesh, description);
    region.nLoops = 1 + static_cast<int>(description.holes.size());
    addEdges(region, boundaryOf(mesh, body, arrangement, boundary), arrangement, boundary);
    double longest = 0;
    region.rowSpacing = region.h;
    for (int e = 0; e < description.nEdges(); ++e) {
        const Curve curve = edgeCurve(description, e);
        if (curve.isArc() || curve.length() < longest * (1 + 1e-9)) continue;
        longest = curve.length();
        region.rowDirection = (curve.point(1) - curve.point(0)) / longest;
        region.rowOrigin = curve.point(0);
        region.rowSpacing = longest / nearestCount(longest / region.h);
    }
    if (longest < 0.5 * region.h) region.rowSpacing = region.h;  // a curve of short edges
    return region;
}

}  // namespace pfem
