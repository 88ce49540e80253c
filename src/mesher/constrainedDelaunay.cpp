#include "mesher/constrainedDelaunay.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <deque>

#include "base/error.hpp"
#include "mesher/hilbertOrder.hpp"

namespace pfem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;  // info: index of the point
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;      // info: loops crossed from outside
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// The points on a grid of a billionth of their extent. Four points on one circle, as corners of a rectangle or of a
/// symmetric trapezoid are, would leave the choice of the diagonal to round-off; on the grid it is the same in all
/// units.
std::vector<Kernel::Point_2> onGrid(const Points<2>& points) {
    Vec<2> low = points.front(), high = low;
    for (const auto& x : points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const double extent = (high - low).maxCoeff();
    std::vector<Kernel::Point_2> result;
    result.reserve(points.size());
    for (const auto& x : points) {
        const Vec<2> place = (x - low) / extent * (1 << 30);
        result.emplace_back(std::rint(place.x()), std::rint(place.y()));
    }
    return result;
}

std::vector<Delaunay::Vertex_handle> insertPoints(Delaunay& delaunay, const Points<2>& points) {
    const auto places = onGrid(points);
    std::vector<Delaunay::Vertex_handle> vertex(points.size());
    Delaunay::Face_handle hint;
    for (const int i : hilbertOrder(points)) {
        vertex[i] = delaunay.insert(places[i], hint);
        vertex[i]->info() = i;
        hint = vertex[i]->face();
    }
    return vertex;
}

/// Number the faces by how many constraints separate them from the outside.
void countCrossings(Delaunay& delaunay) {
    for (const auto face : delaunay.all_face_handles()) face->info() = -1;
    std::deque<Delaunay::Face_handle> queue = {delaunay.infinite_face()};
    queue.front()->info() = 0;
    while (!queue.empty()) {
        const auto face = queue.front();
        queue.pop_front();
        for (int i = 0; i < 3; ++i) {
            const auto next = face->neighbor(i);
            if (next->info() >= 0) continue;
            const bool crossed = face->is_constrained(i);
            next->info() = face->info() + (crossed ? 1 : 0);
            if (crossed)
                queue.push_back(next);
            else
                queue.push_front(next);
        }
    }
}

}  // namespace

std::vector<Simplex<2>> triangulate(const Points<2>& points, const std::vector<Face<2>>& edges) {
    Delaunay delaunay;
    const auto vertex = insertPoints(delaunay, points);
    if (delaunay.number_of_vertices() != points.size()) throw InternalError("triangulate: two points coincide");
    try {
        for (const auto& [a, b] : edges) delaunay.insert_constraint(vertex[a], vertex[b]);
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
        throw InternalError("triangulate: boundary edges cross");
    }
    countCrossings(delaunay);
    std::vector<Simplex<2>> triangles;
    triangles.reserve(2 * points.size());
    for (const auto face : delaunay.finite_face_handles())
        if (face->info() % 2 == 1)
            triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return triangles;
}

}  // namespace pfem
