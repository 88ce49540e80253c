#include "remesh/movedTriangulation.hpp"

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

namespace pfem {

namespace {

Kernel::Point_2 site(const Vec<2>& x) { return {x[0], x[1]}; }

/// Delaunay again, so that what taking out a vertex changes is next to it.
void clearConstraints(Cdt& cdt) {
    Cdt::List_edges freed;
    for (const auto face : cdt.all_face_handles())
        for (int k = 0; k < 3; ++k)
            if (face->is_constrained(k)) {
                face->set_constraint(k, false);
                freed.push_back({face, k});
            }
    cdt.propagating_flip(freed);
}

bool isLeftTurn(Cdt::Vertex_handle a, Cdt::Vertex_handle b, Cdt::Vertex_handle c) {
    return CGAL::orientation(a->info().next, b->info().next, c->info().next) == CGAL::LEFT_TURN;
}

/// The corner of a triangle that lies opposite to its longest side when the points have moved.
Cdt::Vertex_handle apex(Cdt::Face_handle face) {
    Cdt::Vertex_handle best;
    double longest = -1;
    for (int k = 0; k < 3; ++k) {
        const double length =
            CGAL::squared_distance(face->vertex(Cdt::ccw(k))->info().next, face->vertex(Cdt::cw(k))->info().next);
        if (length > longest) {
            longest = length;
            best = face->vertex(k);
        }
    }
    return best;
}

/// Vertices without which the moved points would keep the orientation of these triangles and the hull its shape.
template <class Faces>
void findObstacles(const Cdt& cdt, const Faces& faces, std::vector<int>& obstacles) {
    for (const Cdt::Face_handle face : faces)
        if (!cdt.is_infinite(face) && !isLeftTurn(face->vertex(0), face->vertex(1), face->vertex(2)))
            obstacles.push_back(apex(face)->info().index);
}

/// Corners of the hull that would turn inwards or, on a straight side, pass by a neighbour.
void findDents(const Cdt& cdt, std::vector<int>& obstacles) {
    auto corner = cdt.incident_vertices(cdt.infinite_vertex());
    const auto done = corner;
    do {
        auto before = corner, after = corner;
        --before;
        ++after;
        const auto &a = before->info().next, &b = corner->info().next, &c = after->info().next;
        const auto turn = CGAL::orientation(a, b, c);  // the hull is met clockwise
        if (turn == CGAL::LEFT_TURN ||
            (turn == CGAL::COLLINEAR && !CGAL::collinear_are_strictly_ordered_along_line(a, b, c)))
            obstacles.push_back(corner->info().index);
    } while (++corner != done);
}

/// Lawson's flips; where points are on one circle, the triangulation that symbolic perturbation chooses.
void restoreDelaunay(Cdt& cdt) {
    Cdt::List_edges edges;
    for (const auto& edge : cdt.finite_edges())
        if (cdt.is_flipable(edge.first, edge.second)) edges.push_back(edge);
    cdt.propagating_flip(edges);
}

}  // namespace

void MovedTriangulation::insert(const Points<2>& points, int index, Cdt::Face_handle hint, Handles& handle) {
    const auto before = cdt.number_of_vertices();
    handle[index] = cdt.insert(site(points[index]), hint);
    int& stands = handle[index]->info().index;
    const bool isTwin =
        cdt.number_of_vertices() == before;  // coincides with another point: the first one stands for both
    hasTwins_ |= isTwin;
    stands = isTwin ? std::min(stands, index) : index;
}

Handles MovedTriangulation::fromNothing(const Points<2>& points, const std::vector<int>& active) {
    cdt.clear();
    hasTwins_ = false;
    std::vector<std::pair<Kernel::Point_2, int>> sites;
    sites.reserve(active.size());
    for (int i : active) sites.emplace_back(site(points[i]), i);
    if (sites.empty()) return Handles(points.size());  // all water has left; CGAL sorts something only
    using Map = CGAL::First_of_pair_property_map<std::pair<Kernel::Point_2, int>>;
    CGAL::spatial_sort(sites.begin(), sites.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(),
                       CGAL::Hilbert_sort_middle_policy());
    Handles handle(points.size());
    Cdt::Face_handle hint;
    for (const auto& [point, index] : sites) {
        insert(points, index, hint, handle);
        hint = handle[index]->face();
    }
    return handle;
}

/// False where mending does not pay.
bool MovedTriangulation::takeOver(const Points<2>& points, const std::vector<Id>& ids, const std::vector<int>& active,
                                  Handles& handle) {
    clearConstraints(cdt);
    std::vector<int> fresh;
    std::size_t old = 0, gone = 0;
    const auto passBy = [&](std::size_t end) {  // what has no place among the new points
        for (; old < end; ++old, ++gone) cdt.remove(vertices_[old]);
    };
    for (const int i : active) {
        passBy(std::lower_bound(ids_.begin() + static_cast<std::ptrdiff_t>(old), ids_.end(), ids[i]) - ids_.begin());
        if (old == ids_.size() || ids_[old] != ids[i]) {
            fresh.push_back(i);
            continue;
        }
        handle[i] = vertices_[old++];
        handle[i]->info() = {i, site(points[i])};
    }
    passBy(ids_.size());
    if (fresh.size() + gone > active.size() / 8) return false;

    std::vector<int> obstacles;
    if (cdt.dimension() < 2) return false;
    findObstacles(cdt, cdt.finite_face_handles(), obstacles);
    findDents(cdt, obstacles);
    while (!obstacles.empty()) {
        if (fresh.size() + obstacles.size() > active.size() / 8) return false;
        std::vector<int> around;
        for (const int i : obstacles) {
            if (handle[i] == nullptr) continue;
            auto neighbour = cdt.incident_vertices(handle[i]);
            const auto done = neighbour;
            do {
                if (!cdt.is_infinite(neighbour)) around.push_back(neighbour->info().index);
            } while (++neighbour != done);
            cdt.remove(handle[i]);
            handle[i] = nullptr;
            fresh.push_back(i);
        }
        if (cdt.dimension() < 2) return false;
        obstacles.clear();
        for (const int i : around) {
            if (handle[i] == nullptr) continue;
            std::vector<Cdt::Face_handle> faces;
            auto face = cdt.incident_faces(handle[i]);
            const auto done = face;
            do faces.push_back(face);
            while (++face != done);
            findObstacles(cdt, faces, obstacles);
        }
        findDents(cdt, obstacles);
    }
    for (const int i : active)
        if (handle[i] != nullptr) handle[i]->set_point(handle[i]->info().next);
    restoreDelaunay(cdt);
    std::sort(fresh.begin(), fresh.end());
    for (const int i : fresh) {
        int near = i;  // the last one before it that is there: ids follow a curve that fills the plane
        while (near > 0 && handle[near] == nullptr) --near;
        insert(points, i, handle[near] == nullptr ? Cdt::Face_handle() : handle[near]->face(), handle);
    }
    return true;
}

Handles MovedTriangulation::move(const Points<2>& points, const std::vector<Id>& ids, const std::vector<int>& active) {
    Handles handle(points.size());
    const bool kept = isKept_;
    isKept_ = false;
    if (!kept || !takeOver(points, ids, active, handle)) handle = fromNothing(points, active);
    ids_.clear();
    vertices_.clear();
    for (const int i : active) {
        ids_.push_back(ids[i]);
        vertices_.push_back(handle[i]);
    }
    return handle;
}

}  // namespace pfem
