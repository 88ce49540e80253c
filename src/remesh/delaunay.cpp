#include "remesh/delaunay.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>

#include "base/error.hpp"

namespace pfem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Tds = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds, CGAL::No_constraint_intersection_requiring_constructions_tag>;

std::vector<Cdt::Vertex_handle> insertPoints(Cdt& cdt, const Points<2>& points, const std::vector<int>& active) {
    std::vector<std::pair<Kernel::Point_2, int>> sites;
    sites.reserve(active.size());
    for (int i : active) sites.emplace_back(Kernel::Point_2(points[i][0], points[i][1]), i);
    using Map = CGAL::First_of_pair_property_map<std::pair<Kernel::Point_2, int>>;
    CGAL::spatial_sort(sites.begin(), sites.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(),
                       CGAL::Hilbert_sort_middle_policy());

    std::vector<Cdt::Vertex_handle> handle(points.size());
    Cdt::Face_handle hint;
    for (const auto& [point, index] : sites) {
        const auto before = cdt.number_of_vertices();
        const auto vertex = cdt.insert(point, hint);
        hint = vertex->face();
        handle[index] = vertex;
        if (cdt.number_of_vertices() == before) continue;  // coincides with an earlier point, which stands for both
        vertex->info() = index;
    }
    return handle;
}

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

using Handles = std::vector<Cdt::Vertex_handle>;

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

/// In the order of the cells' first nodes, so that what lies together in the plane lies together in memory.
Triangulation<2> copyCells(Cdt& cdt, std::size_t nPoints) {
    const auto firstNode = [](Cdt::Face_handle face) {
        return std::min({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    };
    std::vector<int> next(nPoints + 1, 0);
    for (const auto face : cdt.finite_face_handles()) ++next[firstNode(face) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    Triangulation<2> result;
    result.cells.resize(next.back());
    result.neighbours.resize(next.back());
    for (const auto face : cdt.all_face_handles()) face->info() = cdt.is_infinite(face) ? -1 : next[firstNode(face)]++;
    for (const auto face : cdt.finite_face_handles())
        for (int k = 0; k < 3; ++k) {
            result.cells[face->info()][k] = face->vertex(k)->info();
            result.neighbours[face->info()][k] = face->neighbor(k)->info();
        }
    return result;
}

}  // namespace

Triangulation<2> constrainedDelaunay(const Points<2>& points, const std::vector<int>& active,
                                     const std::vector<Face<2>>& fixed, const std::vector<Face<2>>& wished) {
    Cdt cdt;
    const Handles handle = insertPoints(cdt, points, active);
    insertFixed(cdt, handle, fixed);
    if (!insertWished(cdt, handle, wished)) return constrainedDelaunay(points, active, fixed, {});
    return copyCells(cdt, points.size());
}

}  // namespace pfem
