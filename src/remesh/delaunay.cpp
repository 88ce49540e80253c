#include "remesh/delaunay.hpp"

#include <algorithm>
#include <numeric>

#include "base/error.hpp"
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
        return "(" + std::to_string(p.x()) + " " + std::to_string(p.y()) + ")";
    };
    for (const auto& face : faces)
        try {
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

Triangulation<2> copyCells(Cdt& cdt, std::size_t nPoints) {
    struct Cell {
        Cdt::Face_handle face;
        int first;   // local number of the smallest node
        int second;  // the node that follows it
    };
    const auto smallest = [](Cdt::Face_handle face) {
        const int a = face->vertex(0)->info().index, b = face->vertex(1)->info().index, c = face->vertex(2)->info().index;
        return a < b ? (a < c ? 0 : 2) : (b < c ? 1 : 2);
    };
    std::vector<int> start(nPoints + 1, 0);
    for (const auto face : cdt.finite_face_handles()) ++start[face->vertex(smallest(face))->info().index + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> next = start;
    std::vector<Cell> cells(start.back());
    for (const auto face : cdt.finite_face_handles()) {
        const int k = smallest(face);
        cells[next[face->vertex(k)->info().index]++] = {face, k, face->vertex(Cdt::ccw(k))->info().index};
    }
    for (std::size_t i = 0; i < nPoints; ++i)
        std::sort(cells.begin() + start[i], cells.begin() + start[i + 1],
                  [](const Cell& a, const Cell& b) { return a.second < b.second; });
    auto infinite = cdt.incident_faces(cdt.infinite_vertex());
    for (const auto done = infinite;;) {
        infinite->info() = -1;
        if (++infinite == done) break;
    }
    for (int e = 0; e < static_cast<int>(cells.size()); ++e) cells[e].face->info() = e;
    Triangulation<2> result;
    result.cells.resize(cells.size());
    result.neighbours.resize(cells.size());
    for (std::size_t e = 0; e < cells.size(); ++e)
        for (int k = 0; k < 3; ++k) {
            const int at = (cells[e].first + k) % 3;
            result.cells[e][k] = cells[e].face->vertex(at)->info().index;
            result.neighbours[e][k] = cells[e].face->neighbor(at)->info();
        }
    return result;
}

}  // namespace

struct Triangulator::Kept : MovedTriangulation {};

Triangulator::Triangulator() : kept_(std::make_unique<Kept>()) {}
Triangulator::~Triangulator() = default;

Triangulation<2> Triangulator::triangulate(const Points<2>& points, const std::vector<Id>& ids,
                                           const std::vector<int>& active, const std::vector<Face<2>>& fixed,
                                           const std::vector<Face<2>>& wished) {
    const Handles handle = kept_->move(points, ids, active);
    if (kept_->cdt.dimension() < 2) return {};
    insertFixed(kept_->cdt, handle, fixed);
    if (!insertWished(kept_->cdt, handle, wished)) {
        kept_->forget();
        return triangulate(points, ids, active, fixed, {});
    }
    auto result = copyCells(kept_->cdt, points.size());
    kept_->keep();
    return result;
}

Triangulation<2> constrainedDelaunay(const Points<2>& points, const std::vector<int>& active,
                                     const std::vector<Face<2>>& fixed, const std::vector<Face<2>>& wished) {
    std::vector<Id> ids(points.size());
    std::iota(ids.begin(), ids.end(), 0);
    return Triangulator().triangulate(points, ids, active, fixed, wished);
}

}  // namespace pfem
