#pragma once
// A Delaunay triangulation that follows its moving points by mending: for delaunay.cpp alone, which hides CGAL.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <vector>

#include "base/types.hpp"

namespace pfem {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct VertexInfo {
    int index = -1;          // among the points
    Kernel::Point_2 next{};  // where the point moves to
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Tds = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds,
                                                       CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Handles = std::vector<Cdt::Vertex_handle>;

struct MovedTriangulation {
    Cdt cdt;

    /// The Delaunay triangulation of the active points, without constraints; the vertex of each point. Mended where the
    /// last one was kept: what would turn a triangle over is taken out before the others move, and put in again; then
    /// edges are flipped.
    Handles move(const Points<2>& points, const std::vector<Id>& ids, const std::vector<int>& active);

    /// The triangulation of move() is to be mended the next time; without this it begins from nothing.
    void keep() { isKept_ = !hasTwins_; }
    void forget() { isKept_ = false; }

private:
    Handles fromNothing(const Points<2>& points, const std::vector<int>& active);
    bool takeOver(const Points<2>& points, const std::vector<Id>& ids, const std::vector<int>& active, Handles& handle);
    void insert(const Points<2>& points, int index, Cdt::Face_handle hint, Handles& handle);

    bool isKept_ = false;
    bool hasTwins_ = false;  // points that coincide
    std::vector<Id> ids_;    // of the active points, ascending, and their vertices
    Handles vertices_;
};

}  // namespace pfem
