#include "mesher/space/checkSurface.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Edge = std::pair<int, int>;

std::map<Edge, std::vector<int>> trianglesOfEdges(const TriSurface& surface) {
    std::map<Edge, std::vector<int>> beside;
    for (int k = 0; k < surface.size(); ++k)
        for (int e = 0; e < 3; ++e)
            beside[std::minmax(surface.triangles[k][e], surface.triangles[k][(e + 1) % 3])].push_back(k);
    return beside;
}

bool runsForward(const Face<3>& t, const Edge& edge) {
    for (int e = 0; e < 3; ++e)
        if (t[e] == edge.first && t[(e + 1) % 3] == edge.second) return true;
    return false;
}

[[noreturn]] void fail(const Geometry& geometry, const std::string& what) {
    const std::string of = geometry.file.empty() ? "" : " of \"" + geometry.file + "\"";
    throw UserError(fmt::format("The surface '{}'{} {}", geometry.name, of, what), geometry.places.of());
}

/// Turn neighbours alike; returns the piece of each triangle.
std::vector<int> turnAlike(Geometry& geometry, const std::map<Edge, std::vector<int>>& beside) {
    auto& surface = geometry.surface;
    std::vector<std::vector<std::pair<int, Edge>>> neighbours(surface.triangles.size());
    for (const auto& [edge, faces] : beside) {
        if (faces.size() > 2)
            fail(geometry, fmt::format("has an edge of {} triangles, from {} to {}", faces.size(),
                                       placeOf(surface.x[edge.first]), placeOf(surface.x[edge.second])));
        if (faces.size() < 2) continue;
        neighbours[faces[0]].push_back({faces[1], edge});
        neighbours[faces[1]].push_back({faces[0], edge});
    }
    std::vector<int> piece(surface.triangles.size(), -1);
    int pieces = 0;
    for (int start = 0; start < surface.size(); ++start) {
        if (piece[start] >= 0) continue;
        std::vector<int> stack{start};
        piece[start] = pieces++;
        while (!stack.empty()) {
            const int k = stack.back();
            stack.pop_back();
            for (const auto& [other, edge] : neighbours[k]) {
                const bool alike =
                    runsForward(surface.triangles[k], edge) != runsForward(surface.triangles[other], edge);
                if (piece[other] < 0) {
                    if (!alike) std::swap(surface.triangles[other][1], surface.triangles[other][2]);
                    piece[other] = piece[k];
                    stack.push_back(other);
                } else if (!alike) {
                    fail(geometry, fmt::format("has only one side, at the edge from {} to {}",
                                               placeOf(surface.x[edge.first]), placeOf(surface.x[edge.second])));
                }
            }
        }
    }
    return piece;
}

void turnOutwards(TriSurface& surface, const std::vector<int>& piece) {
    const int pieces = piece.empty() ? 0 : 1 + *std::max_element(piece.begin(), piece.end());
    std::vector<double> volume(pieces, 0);
    const Vec<3> o = surface.x.front();
    for (int k = 0; k < surface.size(); ++k)
        volume[piece[k]] += (surface.x[surface.triangles[k][0]] - o).dot(faceArea<3>(surface.x, surface.triangles[k]));
    for (int k = 0; k < surface.size(); ++k)
        if (volume[piece[k]] < 0) std::swap(surface.triangles[k][1], surface.triangles[k][2]);
}

int commonPoints(const Face<3>& a, const Face<3>& b) {
    return static_cast<int>(
        std::count_if(a.begin(), a.end(), [&](int i) { return std::find(b.begin(), b.end(), i) != b.end(); }));
}

Kernel::Point_3 at(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

/// Triangles with a common corner cross where the edge opposite to it crosses the other one.
bool crossAtCorner(const TriSurface& s, const Face<3>& a, const Face<3>& b) {
    for (int k = 0; k < 3; ++k)
        if (std::find(b.begin(), b.end(), a[k]) != b.end()) {
            const Kernel::Segment_3 opposite(at(s.x[a[(k + 1) % 3]]), at(s.x[a[(k + 2) % 3]]));
            return CGAL::do_intersect(opposite, Kernel::Triangle_3(at(s.x[b[0]]), at(s.x[b[1]]), at(s.x[b[2]])));
        }
    return false;
}

void checkCrossings(const Geometry& geometry) {
    const auto& s = geometry.surface;
    std::vector<BoxTree::Triangle> triangles;
    for (const auto& [a, b, c] : s.triangles) triangles.push_back({s.x[a], s.x[b], s.x[c]});
    const BoxTree tree(triangles);
    for (int k = 0; k < s.size(); ++k) {
        const Vec<3>&p = triangles[k][0], &q = triangles[k][1], &r = triangles[k][2];
        tree.forEachIn(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r), [&](int other) {
            if (other <= k) return;
            const auto &a = s.triangles[k], &b = s.triangles[other];
            const int common = commonPoints(a, b);
            if (common >= 2) return;
            const bool cross =
                common == 1 ? crossAtCorner(s, a, b) || crossAtCorner(s, b, a)
                            : CGAL::do_intersect(Kernel::Triangle_3(at(p), at(q), at(r)),
                                                 Kernel::Triangle_3(at(s.x[b[0]]), at(s.x[b[1]]), at(s.x[b[2]])));
            if (cross)
                fail(geometry, "crosses or touches itself: the triangles " + placeOf(p) + " " + placeOf(q) + " " +
                                   placeOf(r) + " and " + placeOf(s.x[b[0]]) + " " + placeOf(s.x[b[1]]) + " " +
                                   placeOf(s.x[b[2]]));
        });
    }
}

}  // namespace

std::string placeOf(const Vec<3>& x) { return fmt::format("({:g} {:g} {:g})", x[0], x[1], x[2]); }

void joinPoints(TriSurface& surface) {
    if (surface.x.empty()) return;
    const double tolerance = 1e-9 * (surface.high() - surface.low()).norm();
    std::vector<int> order(surface.x.size()), first(surface.x.size());
    std::iota(order.begin(), order.end(), 0);
    first = order;
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return surface.x[i][0] < surface.x[j][0]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (first[order[i]] != order[i]) continue;
        for (std::size_t j = i + 1; j < order.size() && surface.x[order[j]][0] - surface.x[order[i]][0] <= tolerance;
             ++j)
            if (first[order[j]] == order[j] && (surface.x[order[i]] - surface.x[order[j]]).norm() <= tolerance)
                first[order[j]] = order[i];
    }
    TriSurface joined;
    joined.regions = surface.regions;
    std::vector<int> number(surface.x.size(), -1);
    for (int k = 0; k < surface.size(); ++k) {
        Face<3> t;
        for (int e = 0; e < 3; ++e) t[e] = first[surface.triangles[k][e]];
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (int& i : t) {
            if (number[i] < 0) {
                number[i] = static_cast<int>(joined.x.size());
                joined.x.push_back(surface.x[i]);
            }
            i = number[i];
        }
        joined.triangles.push_back(t);
        joined.region.push_back(surface.region[k]);
    }
    surface = std::move(joined);
}

void splitRegions(TriSurface& surface, double includedAngle) {
    const double least = std::cos((180 - includedAngle) * std::numbers::pi / 180);
    const auto beside = trianglesOfEdges(surface);
    std::vector<std::vector<int>> neighbours(surface.triangles.size());
    for (const auto& [edge, faces] : beside) {
        if (faces.size() != 2 || surface.region[faces[0]] != surface.region[faces[1]]) continue;
        const Vec<3> a = faceArea<3>(surface.x, surface.triangles[faces[0]]).normalized(),
                     b = faceArea<3>(surface.x, surface.triangles[faces[1]]).normalized();
        const bool alike =
            runsForward(surface.triangles[faces[0]], edge) != runsForward(surface.triangles[faces[1]], edge);
        if ((alike ? a.dot(b) : -a.dot(b)) < least) continue;
        neighbours[faces[0]].push_back(faces[1]);
        neighbours[faces[1]].push_back(faces[0]);
    }
    std::vector<int> region(surface.triangles.size(), -1), parts(surface.regions.size(), 0);
    std::vector<std::string> names;
    for (int start = 0; start < surface.size(); ++start) {
        if (region[start] >= 0) continue;
        const int old = surface.region[start], index = static_cast<int>(names.size());
        names.push_back(fmt::format("{}_{}", surface.regions[old], parts[old]++));
        std::vector<int> stack{start};
        region[start] = index;
        while (!stack.empty()) {
            const int k = stack.back();
            stack.pop_back();
            for (const int other : neighbours[k])
                if (region[other] < 0) region[other] = index, stack.push_back(other);
        }
    }
    surface.region = region;
    surface.regions = names;
}

std::vector<std::array<Vec<3>, 2>> freeEdges(const TriSurface& surface) {
    std::vector<std::array<Vec<3>, 2>> edges;
    for (const auto& [edge, faces] : trianglesOfEdges(surface))
        if (faces.size() == 1) edges.push_back({surface.x[edge.first], surface.x[edge.second]});
    return edges;
}

void checkSurface(Geometry& geometry) {
    auto& surface = geometry.surface;
    if (surface.triangles.empty()) fail(geometry, "has no triangle");
    const auto beside = trianglesOfEdges(surface);
    const auto piece = turnAlike(geometry, beside);
    geometry.closed =
        std::all_of(beside.begin(), beside.end(), [](const auto& edge) { return edge.second.size() == 2; });
    if (geometry.closed) turnOutwards(surface, piece);
    if (!geometry.file.empty()) checkCrossings(geometry);
}

}  // namespace pfem
