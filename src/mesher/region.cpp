#include "mesher/region.hpp"

#include <algorithm>
#include <cmath>

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

void addLoop(Region& region, const std::vector<int>& nodes, const BoundaryNodes& boundary) {
    const int first = static_cast<int>(region.x.size()), n = static_cast<int>(nodes.size());
    for (int i = 0; i < n; ++i) {
        region.x.push_back(boundary.x[nodes[i]]);
        region.boundaryNode.push_back(nodes[i]);
        region.edges.push_back({first + i, first + (i + 1) % n});
    }
    region.nBoundary = static_cast<int>(region.x.size());
    ++region.nLoops;
}

/// Per edge of the chain: whether a wall shares it.
void markWalls(Region& region, const std::vector<PieceRef>& chain, bool backward,
               const Arrangement& arrangement, const BoundaryNodes& boundary) {
    std::vector<bool> marks;
    for (const auto& ref : chain) {
        const auto& uses = arrangement.pieces[ref.piece].uses;
        const bool wall =
            std::any_of(uses.begin(), uses.end(), [&](const auto& use) { return arrangement.isWall(use); });
        marks.insert(marks.end(), boundary.ofPiece[ref.piece].size() - 1, wall);
    }
    if (backward) std::reverse(marks.begin(), marks.end() - 1);  // the loop closes with its last edge
    region.onWall.insert(region.onWall.end(), marks.begin(), marks.end());
}

}  // namespace

Region regionOf(const MeshDescription& mesh, int body, const Arrangement& arrangement,
                const BoundaryNodes& boundary) {
    const Body& description = mesh.bodies[body];
    Region region;
    region.fluid = description.type == BodyType::fluid;
    region.h = bodySize(mesh, description);
    addLoop(region, boundary.chain(arrangement, body, true), boundary);
    markWalls(region, arrangement.chains[body], false, arrangement, boundary);
    for (const auto& name : description.holes) {
        const int hole = bodyIndex(mesh, name);
        auto nodes = boundary.chain(arrangement, hole, true);
        std::reverse(nodes.begin(), nodes.end());
        addLoop(region, nodes, boundary);
        markWalls(region, arrangement.chains[hole], true, arrangement, boundary);
    }
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
    return region;
}

}  // namespace pfem
