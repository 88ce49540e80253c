#include "mesher/groupWalls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "mesh/bins.hpp"
#include "mesher/segmentDistance.hpp"

namespace pfem {

namespace {

constexpr double onLine = 1e-3;  // distance / mean edge at which a node lies on a line

bool has(const Sides& sides, const Face<2>& face) { return sides.count(face) > 0; }

}  // namespace

std::vector<Face<2>> orientWall(const std::vector<WallEdge>& edges, const Sides& sides) {
    std::vector<Face<2>> faces;
    std::vector<char> known(edges.size(), 0);
    std::multimap<int, int> at;  // node -> edges
    std::deque<int> queue;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Face<2> face = edges[e].nodes, back = {face[1], face[0]};
        faces.push_back(face);
        for (const int node : face) at.emplace(node, static_cast<int>(e));
        if (has(sides, face) && has(sides, back)) throw WallBetween{face[0], edges[e].line};
        if (!has(sides, face) && !has(sides, back)) continue;
        if (has(sides, back)) faces[e] = back;
        known[e] = 1;
        queue.push_back(static_cast<int>(e));
    }
    const auto spread = [&] {
        for (; !queue.empty(); queue.pop_front()) {
            const Face<2> face = faces[queue.front()];
            for (const int node : face) {
                const auto [first, last] = at.equal_range(node);
                if (std::distance(first, last) > 2) continue;  // a branching wall: each arm for itself
                for (auto it = first; it != last; ++it) {
                    Face<2>& next = faces[it->second];
                    if (known[it->second]) continue;
                    if ((node == face[1]) != (next[0] == node)) std::swap(next[0], next[1]);
                    known[it->second] = 1;
                    queue.push_back(it->second);
                }
            }
        }
    };
    spread();
    for (std::size_t e = 0; e < edges.size(); ++e) {  // dry pieces: as their first edge
        if (known[e]) continue;
        known[e] = 1;
        queue.push_back(static_cast<int>(e));
        spread();
    }
    std::vector<Face<2>> kept;
    for (const auto& face : faces)
        if (const auto side = sides.find(face); side == sides.end() || side->second == BodyType::fluid)
            kept.push_back(face);
    return kept;
}

void addPointWall(const Wall& wall, const Sides& sides, double meanSize, Draft& draft, Patch<2>& patch) {
    if (!wall.arcs.empty())
        throw UserError("wall '" + wall.name + "': with a mesh file a curved wall must be a group of its edges",
                        wall.at("edges"));
    const double tolerance = onLine * meanSize;
    std::set<int> outline;
    for (const auto& [face, type] : sides)
        if (!has(sides, {face[1], face[0]})) outline.insert(face.begin(), face.end());
    const auto corner = [&](const Vec<2>& x) {
        for (int i = 0; i < static_cast<int>(draft.x.size()); ++i)
            if ((draft.x[i] - x).norm() <= tolerance) return i;
        draft.x.push_back(x);
        draft.v.push_back(Vec<2>::Zero());
        draft.h.push_back(wall.meshSize > 0 ? wall.meshSize : meanSize);
        return static_cast<int>(draft.x.size()) - 1;
    };
    std::vector<int> corners;
    for (const auto& x : wall.points) corners.push_back(corner(x));
    if (wall.closed) corners.push_back(corners.front());
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const Vec<2> a = draft.x[corners[k]], d = draft.x[corners[k + 1]] - a;
        const double length = d.norm();
        if (!(length > tolerance))
            throw UserError("wall '" + wall.name + "' has the same point twice", wall.at("points"));
        std::vector<std::pair<double, int>> on = {{0.0, corners[k]}, {length, corners[k + 1]}};
        for (const int i : outline) {
            if (i == corners[k] || i == corners[k + 1]) continue;
            const Vec<2> r = draft.x[i] - a;
            const double s = r.dot(d) / length;
            if (s <= 0 || s >= length || std::abs(d.x() * r.y() - d.y() * r.x()) / length > tolerance) continue;
            on.emplace_back(s, i);
            draft.x[i] = a + s / length * d;
        }
        std::sort(on.begin(), on.end());
        for (std::size_t i = 0; i + 1 < on.size(); ++i) {
            const Face<2> face = {on[i].second, on[i + 1].second}, back = {face[1], face[0]};
            if (has(sides, back))
                throw UserError(
                    fmt::format("wall '{}' has a body on its right at ({:g} {:g}): the line of a wall has the "
                                "fluid on its left, turn its points around",
                                wall.name, draft.x[face[0]].x(), draft.x[face[0]].y()),
                    wall.at("points"));
            const auto side = sides.find(face);
            if (side == sides.end() || side->second == BodyType::fluid) patch.faces.push_back(face);
        }
    }
}

void checkTouching(const Draft& draft, const Sides& sides, double meanSize) {
    std::vector<Face<2>> outline;
    for (const auto& [face, type] : sides)
        if (!has(sides, {face[1], face[0]})) outline.push_back(face);
    double longest = 0;
    for (const auto& [a, b] : outline) longest = std::max(longest, (draft.x[b] - draft.x[a]).norm());
    Bins<2> nodes(draft.x, longest);
    for (const auto& face : outline) nodes.add(face[0], draft.x[face[0]], draft.x[face[0]]);
    for (const auto& [a, b] : outline) {
        const Vec<2> d = draft.x[b] - draft.x[a];
        nodes.parallelFor(draft.x[a].cwiseMin(draft.x[b]), draft.x[a].cwiseMax(draft.x[b]), [&, a = a, b = b](int i) {
            const double s = (draft.x[i] - draft.x[a]).dot(d) / d.squaredNorm();
            if (i == a || i == b || s <= onLine || s >= 1 - onLine) return;
            if (segmentDistance(draft.x[i], draft.x[a], draft.x[b]) > onLine * std::min(meanSize, d.norm())) return;
            throw UserError(
                fmt::format("bodies touch at ({:g} {:g}) without common nodes: make the geometry of one piece "
                            "(Gmsh: BooleanFragments, or common points and curves)",
                            draft.x[i].x(), draft.x[i].y()));
        });
    }
}

}  // namespace pfem
