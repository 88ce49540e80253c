#include "remesh/delaunay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "remesh/movedTriangulation.hpp"

namespace pfem {

namespace {

/// True when a-b crosses a constrained edge or cannot be followed.
bool isBlocked(const Cdt& cdt, Cdt::Vertex_handle a, Cdt::Vertex_handle b) {
    auto start = a->face();
    for (auto around = cdt.incident_faces(a); cdt.is_infinite(start); ++around) start = around;
    auto walk = cdt.line_walk(a->point(), b->point(), start);
    if (walk == nullptr) return true;
    for (const auto done = walk;;) {
        if (cdt.is_infinite(walk)) return true;
        for (int k = 0; k < 3; ++k) {
            if (!walk->is_constrained(k)) continue;
            const auto p = walk->vertex(cdt.cw(k));
            const auto q = walk->vertex(cdt.ccw(k));
            if (p == a || p == b || q == a || q == b) continue;
            const auto side = [](auto u, auto v, auto w) {
                return CGAL::orientation(u->point(), v->point(), w->point());
            };
            if (side(a, b, p) != side(a, b, q) && side(p, q, a) != side(p, q, b)) return true;
        }
        if (walk->has_vertex(b)) return false;
        if (++walk == done) return true;
    }
}

bool haveEdge(const Handles& handle, const Face<2>& face) {
    return handle[face[0]] != nullptr && handle[face[1]] != nullptr && handle[face[0]] != handle[face[1]];
}

void insertFixed(Cdt& cdt, const Handles& handle, const std::vector<Face<2>>& faces) {
    const auto place = [&](int node) {
        const auto& p = handle[node]->point();
        return fmt::format("({:.6g} {:.6g})", p.x(), p.y());
    };
    for (const auto& face : faces) try {
            if (haveEdge(handle, face)) cdt.insert_constraint(handle[face[0]], handle[face[1]]);
        } catch (const Cdt::Intersection_of_constraints_exception&) {
            throw StepFailure("walls and solids cross each other between " + place(face[0]) + " and " + place(face[1]));
        }
}

/// False when the triangulation was spoilt by crossing edges that the check had not seen.
bool insertWished(Cdt& cdt, const Handles& handle, const std::vector<Face<2>>& faces) {
    try {
        for (const auto& face : faces) {
            if (!haveEdge(handle, face)) continue;
            const auto a = handle[face[0]], b = handle[face[1]];
            if (cdt.is_edge(a, b) || !isBlocked(cdt, a, b)) cdt.insert_constraint(a, b);
        }
    } catch (const Cdt::Intersection_of_constraints_exception&) {
        return false;
    }
    return true;
}

/// A triangle and its nodes, turned so that the smallest comes first.
struct Turned {
    Cdt::Face_handle face;
    int first = 0;  // local number of the smallest node
    Simplex<2> nodes{};
};

Turned turned(Cdt::Face_handle face) {
    const auto node = [&](int k) { return face->vertex(k)->info().index; };
    const int a = node(0), b = node(1), c = node(2);
    const int k = a < b ? (a < c ? 0 : 2) : (b < c ? 1 : 2);
    return {face, k, {node(k), node(Cdt::ccw(k)), node(Cdt::cw(k))}};
}

/// By their first nodes, then by the second.
std::vector<Turned> sortedCells(const Cdt& cdt, int nPoints) {
    std::vector<Turned> found;
    found.reserve(cdt.number_of_faces());
    for (const auto face : cdt.finite_face_handles()) found.push_back({face});
    const int nCells = static_cast<int>(found.size());
    parallelFor(nCells, [&](int e) { found[e] = turned(found[e].face); });
    std::vector<int> start(nPoints + 1, 0);
    for (const Turned& cell : found) ++start[cell.nodes[0] + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> next = start, order(nCells);
    for (int e = 0; e < nCells; ++e) order[next[found[e].nodes[0]]++] = e;
    std::vector<Turned> cells(nCells);
    parallelFor(nPoints, [&](int i) {
        std::sort(order.begin() + start[i], order.begin() + start[i + 1],
                  [&](int a, int b) { return found[a].nodes[1] < found[b].nodes[1]; });
        for (int e = start[i]; e < start[i + 1]; ++e) cells[e] = found[order[e]];
    });
    return cells;
}

}  // namespace

template <>
struct Triangulator<2>::Kept : MovedTriangulation {
    Triangulation<2> result;
};

template <>
Triangulator<2>::Triangulator(Ranks ranks, double halo) : ranks_(ranks), halo_(halo), kept_(std::make_unique<Kept>()) {}
template <>
Triangulator<2>::~Triangulator() = default;
template <>
Triangulator<2>::Triangulator(Triangulator&&) noexcept = default;
template <>
Triangulator<2>& Triangulator<2>::operator=(Triangulator&&) noexcept = default;

template <>
void Triangulator<2>::follow(const Points<2>& points, const std::vector<Id>& ids, const std::vector<int>& active,
                             const std::vector<Face<2>>& fixed, const std::vector<Face<2>>& wished) {
    const Handles handle = kept_->move(points, ids, active);
    if (kept_->cdt.dimension() < 2) return;
    insertFixed(kept_->cdt, handle, fixed);
    if (!insertWished(kept_->cdt, handle, wished)) {
        kept_->forget();
        return follow(points, ids, active, fixed, {});
    }
    kept_->keep();
}

template <>
const Triangulation<2>& Triangulator<2>::triangulation(int nPoints) {
    Cdt& cdt = kept_->cdt;
    Triangulation<2>& result = kept_->result;
    result = {};
    if (cdt.dimension() < 2) return result;
    const auto cells = sortedCells(cdt, nPoints);
    const int nCells = static_cast<int>(cells.size());
    auto infinite = cdt.incident_faces(cdt.infinite_vertex());
    for (const auto done = infinite;;) {
        infinite->info() = -1;
        if (++infinite == done) break;
    }
    parallelFor(nCells, [&](int e) { cells[e].face->info() = e; });
    result.cells.resize(nCells);
    result.neighbours.resize(nCells);
    parallelFor(nCells, [&](int e) {
        result.cells[e] = cells[e].nodes;
        for (int k = 0; k < 3; ++k) result.neighbours[e][k] = cells[e].face->neighbor((cells[e].first + k) % 3)->info();
    });
    return result;
}

Triangulation<2> constrainedDelaunay(const Points<2>& points, const std::vector<int>& active,
                                     const std::vector<Face<2>>& fixed, const std::vector<Face<2>>& wished) {
    std::vector<Id> ids(points.size());
    std::iota(ids.begin(), ids.end(), 0);
    Triangulator<2> triangulator;
    triangulator.follow(points, ids, active, fixed, wished);
    return triangulator.triangulation(static_cast<int>(points.size()));
}

}  // namespace pfem
