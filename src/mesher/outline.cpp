#include "mesher/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesher/counts.hpp"

namespace pfem {

Location Outline::at(const std::string& keyword) const {
    auto it = places.find(keyword);
    if (it == places.end()) it = places.find("");
    return it == places.end() ? Location{} : it->second;
}

Location Outline::atPoint(int k, const std::string& keyword) const {
    return k < static_cast<int>(pointPlaces.size()) ? pointPlaces[k] : at(keyword);
}

int bodyIndex(const MeshDescription& mesh, const std::string& name) {
    for (std::size_t i = 0; i < mesh.bodies.size(); ++i)
        if (mesh.bodies[i].name == name) return static_cast<int>(i);
    return -1;
}

const Outline& outlineOf(const MeshDescription& mesh, int index) {
    const int n = static_cast<int>(mesh.bodies.size());
    if (index < n) return mesh.bodies[index];
    return mesh.walls[index - n];
}

std::string titleOf(const MeshDescription& mesh, int outline) {
    const bool wall = outline >= static_cast<int>(mesh.bodies.size());
    return fmt::format("{} '{}'", wall ? "wall" : "body", outlineOf(mesh, outline).name);
}

std::string pointsWord(const MeshDescription& mesh, int outline) {
    return outline < static_cast<int>(mesh.bodies.size()) ? "vertices" : "points";
}

double mergeDistance(const MeshDescription& mesh) {
    double smallest = 0;
    for (const auto& body : mesh.bodies)
        if (const double h = bodySize(mesh, body); h > 0 && (smallest == 0 || h < smallest)) smallest = h;
    return 1e-6 * smallest;
}

std::vector<int> distinctPoints(const Outline& outline, double tolerance) {
    std::vector<int> distinct;
    const auto same = [&](int i, int j) { return (outline.points[i] - outline.points[j]).norm() <= tolerance; };
    for (int i = 0; i < static_cast<int>(outline.points.size()); ++i)
        if (distinct.empty() || !same(i, distinct.back())) distinct.push_back(i);
    while (outline.closed && distinct.size() > 1 && same(distinct.back(), distinct.front())) distinct.pop_back();
    return distinct;
}

std::vector<std::string> patchesOf(const Body& body, int edge) {
    const int n = static_cast<int>(body.points.size()), from = edge, to = (edge + 1) % n;
    const auto isEdge = [&](const auto& ends) {  // two edges join the same two vertices: the order tells which
        const auto& [a, b] = ends;
        return (a == from && b == to) || (n > 2 && a == to && b == from);
    };
    std::vector<std::string> names;
    for (const auto& [name, edges] : body.patches)
        if (edge >= 0 && std::any_of(edges.begin(), edges.end(), isEdge)) names.push_back(name);
    return names;
}

Curve edgeCurve(const Outline& outline, int edge) {
    const int n = static_cast<int>(outline.points.size());
    const int from = edge, to = (edge + 1) % n;
    const Vec<2>&a = outline.points[from], &b = outline.points[to];
    for (const auto& arc : outline.arcs) {
        const bool same = arc.from == from && arc.to == to;
        const bool reverse = n > 2 && arc.from == to && arc.to == from;
        if (!same && !reverse) continue;
        if (const auto curve = Curve::arc(a, arc.through, b)) return *curve;
        throw UserError(fmt::format("arc {} {} ({:g} {:g}) of '{}': the three points lie on one line", arc.from, arc.to,
                                    arc.through.x(), arc.through.y(), outline.name),
                        outline.at("edges"));
    }
    return Curve::line(a, b);
}

double outlineArea(const Outline& outline) {
    double twice = 0;
    const Vec<2> first = outline.points.front();  // areas as seen from it: exact wherever the origin is
    Vec<2> previous = Vec<2>::Zero();
    for (int e = 0; e < outline.nEdges(); ++e) {
        const Curve curve = edgeCurve(outline, e);
        const int n = curve.isArc() ? 64 : 1;
        for (int k = 1; k <= n; ++k) {
            const Vec<2> x = curve.point(double(k) / n) - first;
            twice += previous.x() * x.y() - previous.y() * x.x();
            previous = x;
        }
    }
    return 0.5 * twice;
}

double bodySize(const MeshDescription& mesh, const Body& body) {
    if (body.meshSize > 0) return body.meshSize;
    if (body.pattern != Pattern::unstructured && body.cells[0] > 0)
        return std::sqrt(outlineArea(body) / (body.cells[0] * body.cells[1]));
    return mesh.meshSize;
}

std::array<int, 2> patternCells(const MeshDescription& mesh, const Body& body) {
    if (body.cells[0] > 0) return body.cells;
    const double h = bodySize(mesh, body);
    const auto divide = [&](int edge) {
        const double mean = 0.5 * (edgeCurve(body, edge).length() + edgeCurve(body, edge + 2).length());
        return nearestCount(mean / h);
    };
    return {divide(0), divide(1)};
}

}  // namespace pfem
