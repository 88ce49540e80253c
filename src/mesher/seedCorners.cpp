#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mesher/region.hpp"
#include "mesher/segmentDistance.hpp"

namespace pfem {

// A corner whose two edges belong to one triangle has no inner edge: between rigid walls that triangle has
// no free node (no pressure can move it). A point on the bisector, one edge length from the corner, lies
// inside the circle through the corner and its neighbours, so that Delaunay joins it to the corner.
// Corners above 150 degrees get two or more triangles by themselves; acute ones keep one, except between
// walls.
void seedCorners(Region& region) {
    std::vector<std::vector<int>> into(region.nBoundary);  // edges
    for (int e = 0; e < static_cast<int>(region.edges.size()); ++e) into[region.edges[e][1]].push_back(e);
    const double degree = std::numbers::pi / 180;
    for (int next = 0; next < static_cast<int>(region.edges.size()); ++next) {
        const int i = region.edges[next][0];
        const Vec<2> out = region.x[region.edges[next][1]] - region.x[i];
        const auto angleTo = [&](int e) {  // of the region, from `out` counter-clockwise
            const Vec<2> in = region.x[region.edges[e][0]] - region.x[i];
            const double angle = std::atan2(out.x() * in.y() - out.y() * in.x(), out.dot(in));
            return angle > 0 ? angle : angle + 360 * degree;
        };
        const int previous =
            *std::min_element(into[i].begin(), into[i].end(), [&](int e, int f) { return angleTo(e) < angleTo(f); });
        const Vec<2> in = region.x[region.edges[previous][0]] - region.x[i];
        const double angle = angleTo(previous);
        if (angle > (150 + 1e-9) * degree) continue;  // reflex, or wide enough
        const bool betweenWalls = region.fluid && region.onWall[next] && region.onWall[previous];
        if (angle < (80 - 1e-9) * degree && !betweenWalls) continue;
        const Vec<2> bisector = (out.normalized() + in.normalized()).normalized();
        const double h = std::min(out.norm(), in.norm());
        const Vec<2> x = region.x[i] + h * bisector;
        bool free = true;
        for (const auto& [a, b] : region.edges)
            free = free && (a == i || b == i || segmentDistance(x, region.x[a], region.x[b]) > 0.35 * h);
        for (const auto& other : region.anchors) free = free && (other.x - x).norm() > 0.6 * h;
        if (!free) continue;
        const double radius = 0.5 * h / std::cos(0.5 * angle);  // of the circle; the bisector is its diameter
        const double slack = radius - std::abs(radius - h);     // from x to the circle
        region.anchors.push_back({x, std::min(0.25 * h, 0.7 * slack)});
        region.x.push_back(x);
    }
}

}  // namespace pfem
