#include "remesh/delaunay.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

namespace pfem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Tds = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds, CGAL::No_constraint_intersection_tag>;

std::vector<Cdt::Vertex_handle> insertPoints(Cdt& cdt, const Points<2>& points, const std::vector<int>& active) {
    std::vector<std::pair<Kernel::Point_2, int>> sites;
    sites.reserve(active.size());
    for (int i : active) sites.emplace_back(Kernel::Point_2(points[i][0], points[i][1]), i);
    using Map = CGAL::First_of_pair_property_map<std::pair<Kernel::Point_2, int>>;
    CGAL::spatial_sort(sites.begin(), sites.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());

    std::vector<Cdt::Vertex_handle> handle(points.size());
    Cdt::Face_handle hint;
    for (const auto& [point, index] : sites) {
        const auto before = cdt.number_of_vertices();
        const auto vertex = cdt.insert(point, hint);
        hint = vertex->face();
        if (cdt.number_of_vertices() == before) continue;  // coincides with an earlier point
        vertex->info() = index;
        handle[index] = vertex;
    }
    return handle;
}

/// True when the open segment a-b crosses a constrained edge or passes through a vertex.
bool isBlocked(const Cdt& cdt, Cdt::Vertex_handle a, Cdt::Vertex_handle b) {
    auto walk = cdt.line_walk(a->point(), b->point(), a->face());
    const auto done = walk;
    if (walk == nullptr) return true;
    do {
        if (!cdt.is_infinite(walk))
            for (int k = 0; k < 3; ++k) {
                if (!walk->is_constrained(k)) continue;
                const auto p = walk->vertex(cdt.cw(k));
                const auto q = walk->vertex(cdt.ccw(k));
                if (p == a || p == b || q == a || q == b) continue;
                const auto side = [&](auto v, auto w, auto u) {
                    return CGAL::orientation(v->point(), w->point(), u->point());
                };
                if (side(a, b, p) != side(a, b, q) && side(p, q, a) != side(p, q, b)) return true;
            }
        if (walk->has_vertex(b)) break;
    } while (++walk != done);
    return false;
}

void insertConstraints(Cdt& cdt, const std::vector<Cdt::Vertex_handle>& handle,
                       const std::vector<Face<2>>& constraints) {
    for (const auto& [i, j] : constraints) {
        const auto a = handle[i];
        const auto b = handle[j];
        if (a == nullptr || b == nullptr || a == b) continue;
        Cdt::Face_handle face;
        int k = 0;
        if (cdt.is_edge(a, b, face, k) || !isBlocked(cdt, a, b)) cdt.insert_constraint(a, b);
    }
}

}  // namespace

Triangulation<2> constrainedDelaunay(const Points<2>& points, const std::vector<int>& active,
                                     const std::vector<Face<2>>& constraints) {
    Cdt cdt;
    const auto handle = insertPoints(cdt, points, active);
    insertConstraints(cdt, handle, constraints);

    Triangulation<2> result;
    int count = 0;
    for (auto face = cdt.all_faces_begin(); face != cdt.all_faces_end(); ++face)
        face->info() = cdt.is_infinite(face) ? -1 : count++;
    result.cells.reserve(count);
    result.neighbours.reserve(count);
    for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
        result.cells.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
        result.neighbours.push_back(
            {face->neighbor(0)->info(), face->neighbor(1)->info(), face->neighbor(2)->info()});
    }
    return result;
}

}  // namespace pfem
