#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesher/checks.hpp"
#include "mesher/thinOut.hpp"

namespace pfem {

namespace {

std::string pointList(const Points<2>& points) {
    std::string text = "(";
    for (const auto& x : points) text += fmt::format("{}({:g} {:g})", text.size() > 1 ? " " : "", x.x(), x.y());
    return text + ")";
}

void checkOutline(const Outline& outline, const char* what, const char* keyword, double tolerance) {
    const auto n = outline.points.size(), different = distinctPoints(outline, tolerance).size(),
               least = std::size_t(outline.closed && outline.arcs.empty() ? 3 : 2);
    if (different < least)
        throw UserError(fmt::format("{} '{}' has {}{} points; at least {} are needed", what, outline.name, different,
                                    different < n ? " different" : "", least),
                        outline.at(keyword));
    if (outline.meshSize < 0)
        throw UserError(fmt::format("meshSize of '{}' must be positive, not {:g}", outline.name, outline.meshSize),
                        outline.at("meshSize"));
    for (const auto& arc : outline.arcs) {
        const int m = static_cast<int>(n), low = std::min(arc.from, arc.to), high = std::max(arc.from, arc.to);
        const bool edge = low >= 0 && high < m && (high == low + 1 || (outline.closed && low == 0 && high == m - 1));
        if (!edge)
            throw UserError(fmt::format("arc {} {}: '{}' has no edge between these points (it has points 0 to {})",
                                        arc.from, arc.to, outline.name, m - 1),
                            outline.at("edges"));
        if ((outline.points[arc.from] - outline.points[arc.to]).norm() <= tolerance)
            throw UserError(
                fmt::format("arc {0} {1}: the points {0} and {1} of '{2}' are one", arc.from, arc.to, outline.name),
                outline.at("edges"));
    }
}

/// Twice the width of a slender body, or the diameter of a round one; what is rough below half of the size does not
/// count.
double widthOf(const Body& body, double h) {
    const double area = outlineArea(body);
    double perimeter = 0;
    Points<2> straight = {body.points.front()};
    for (int e = 0; e < body.nEdges(); ++e) {
        const Curve curve = edgeCurve(body, e);
        if (curve.isArc()) {
            perimeter += lengthWithin(straight, 0.5 * h) + curve.length();
            straight.clear();
        }
        straight.push_back(curve.point(1));
    }
    return 4 * area / (perimeter + lengthWithin(straight, 0.5 * h));
}

void checkBody(const MeshDescription& mesh, int index, double tolerance) {
    const Body& body = mesh.bodies[index];
    const double area = outlineArea(body), h = bodySize(mesh, body);
    if (area < 0) {
        checkShape(mesh, index, true);
        Points<2> reversed(body.points.rbegin(), body.points.rend());
        throw UserError(fmt::format("The vertices of body '{}' run clockwise; write them counter-clockwise:\n{}",
                                    body.name, pointList(reversed)),
                        body.at("vertices"));
    }
    if (!(h > 0))
        throw UserError(fmt::format("Body '{}' has no meshSize, and the dictionary has no default one", body.name),
                        body.at());
    if (const double width = widthOf(body, h); h > width) {
        checkShape(mesh, index, true);
        throw UserError(fmt::format("meshSize {:g} is larger than body '{}' (about {:.3g} wide)", h, body.name, width),
                        body.meshSize > 0 ? body.at("meshSize") : body.at());
    }
    if (body.pattern != Pattern::unstructured &&
        (body.points.size() != 4 || distinctPoints(body, tolerance).size() != 4 || !body.holes.empty()))
        throw UserError(fmt::format("A structured pattern needs four vertices and no holes; body '{}' has {} vertices",
                                    body.name, body.points.size()),
                        body.at("pattern"));
    if (body.cells[0] < 0 || body.cells[1] < 0 || (body.cells[0] == 0) != (body.cells[1] == 0))
        throw UserError(fmt::format("cells of '{}' must be two positive numbers", body.name), body.at("cells"));
    const int n = static_cast<int>(body.points.size());
    for (const auto& [name, edges] : body.patches)
        for (const auto& [a, b] : edges)
            if (a < 0 || b < 0 || a >= n || b >= n || ((a + 1) % n != b && (b + 1) % n != a))
                throw UserError(fmt::format("patch '{}': body '{}' has no edge ({} {}); its edges join the vertices "
                                            "0 to {} in their order, the last one with the first",
                                            name, body.name, a, b, n - 1),
                                body.at("patches"));
    for (const auto& hole : body.holes) {
        if (std::count(body.holes.begin(), body.holes.end(), hole) > 1)
            throw UserError(fmt::format("Body '{}' has the hole '{}' twice", body.name, hole), body.at("holes"));
        if (bodyIndex(mesh, hole) < 0 || hole == body.name) {
            std::vector<std::string> names;
            for (const auto& other : mesh.bodies)
                if (other.name != body.name) names.push_back(other.name);
            throw UserError(notValid(hole, "body", names), body.at("holes"));
        }
    }
}

}  // namespace

void checkDescription(const MeshDescription& mesh) {
    if (mesh.bodies.empty()) throw UserError("There is no body to mesh");
    if (mesh.meshSize < 0) throw UserError(fmt::format("meshSize must be positive, not {:g}", mesh.meshSize));
    const double tolerance = mergeDistance(mesh);
    for (int b = 0; b < static_cast<int>(mesh.bodies.size()); ++b) {
        checkOutline(mesh.bodies[b], "Body", "vertices", tolerance);
        checkShape(mesh, b);
        checkBody(mesh, b, tolerance);
    }
    std::set<std::string> names;
    for (std::size_t w = 0; w < mesh.walls.size(); ++w) {
        checkOutline(mesh.walls[w], "Wall", "points", tolerance);
        checkShape(mesh, static_cast<int>(mesh.bodies.size() + w));
        names.insert(mesh.walls[w].name);
    }
    for (const auto& body : mesh.bodies)
        for (const auto& [name, edges] : body.patches)
            if (names.count(name))
                throw UserError(fmt::format("patch '{}' of body '{}' has the name of a wall", name, body.name),
                                body.at("patches"));
}

void checkCount(const MeshDescription& mesh) {
    double total = 0;
    for (const auto& body : mesh.bodies) {
        const double h = bodySize(mesh, body);
        double count = outlineArea(body) / (std::sqrt(3.0) / 4 * h * h);
        if (body.pattern != Pattern::unstructured && body.cells[0] > 0)
            count = (body.pattern == Pattern::crossed ? 4.0 : 2.0) * body.cells[0] * body.cells[1];
        total += count;
    }
    for (const auto& wall : mesh.walls) {
        const double h = wall.meshSize > 0 ? wall.meshSize : mesh.meshSize;
        for (int e = 0; e < wall.nEdges() && h > 0; ++e) total += edgeCurve(wall, e).length() / h;
    }
    Vec<2> low = mesh.bodies.front().points.front(), high = low;
    for (const auto& body : mesh.bodies)
        for (const auto& x : body.points) low = low.cwiseMin(x), high = high.cwiseMax(x);
    for (Refinement refinement : mesh.refinements) {
        if (refinement.box)
            refinement.points = {refinement.points[0].cwiseMax(low).cwiseMin(high),
                                 refinement.points[1].cwiseMax(low).cwiseMin(high)};
        const double count = refinement.area() / (std::sqrt(3.0) / 4 * refinement.meshSize * refinement.meshSize);
        if (count > 2e7)
            throw UserError(fmt::format("Refinement '{}' would have about {:.1e} triangles. Check its meshSize and the "
                                        "units (metres).",
                                        refinement.name, count),
                            refinement.where);
    }
    if (total > 2e7)
        throw UserError(fmt::format("The mesh would have about {:.1e} triangles and wall faces. "
                                    "Check meshSize and the units (metres).",
                                    total),
                        mesh.bodies.front().at("meshSize"));
}

}  // namespace pfem
