#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <omp.h>

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "remesh/delaunay.hpp"
#include "remesh/mendedDelaunay.hpp"
#include "remesh/sharedDelaunay.hpp"
#include "remesh/spaceDelaunay.hpp"

namespace pfem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

constexpr int leastPart = 2000;  // points; of smaller parts too much is halo

/// A tetrahedron with its nodes in an even order, the smallest first, then the next smallest.
struct Turned {
    Delaunay::Cell_handle cell;
    std::array<int, 4> local{};  // numbers in the cell
    Simplex<3> nodes{};
};

Turned turned(Delaunay::Cell_handle cell) {
    Turned t{cell, {0, 1, 2, 3}, {}};
    const auto node = [&](int k) { return cell->vertex(t.local[k])->info(); };
    const auto smallest = [&](int from) {
        int best = from;
        for (int k = from + 1; k < 4; ++k)
            if (node(k) < node(best)) best = k;
        return best;
    };
    if (const int k = smallest(0); k > 0) {  // two swaps: the orientation stays
        std::swap(t.local[0], t.local[k]);
        std::swap(t.local[k == 1 ? 2 : 1], t.local[3 - (k == 3 ? 1 : 0)]);
    }
    const int k = smallest(1);  // turn the other three
    std::rotate(t.local.begin() + 1, t.local.begin() + k, t.local.end());
    for (int i = 0; i < 4; ++i) t.nodes[i] = node(i);
    return t;
}

/// The finite cells in Triangulator's order; infinite ones get the number -1. `nPoints`: more than any node's number.
std::vector<Turned> sortedCells(const Delaunay& triangulation, std::size_t nPoints) {
    std::vector<Turned> found;
    found.reserve(triangulation.number_of_cells());
    for (const auto cell : triangulation.all_cell_handles())
        if (triangulation.is_infinite(cell))
            cell->info() = -1;
        else
            found.push_back({cell});
    parallelFor(static_cast<int>(found.size()), [&](int e) { found[e] = turned(found[e].cell); });
    std::vector<int> start(nPoints + 1, 0);  // of those with the same first node
    for (const auto& cell : found) ++start[cell.nodes[0] + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Turned> cells(found.size());
    std::vector<int> next(start.begin(), start.end() - 1);
    for (const auto& cell : found) cells[next[cell.nodes[0]]++] = cell;
    parallelFor(static_cast<int>(nPoints), [&](int i) {
        std::sort(cells.begin() + start[i], cells.begin() + start[i + 1],
                  [](const Turned& a, const Turned& b) { return a.nodes < b.nodes; });
    });
    return cells;
}

/// -1 for those that take no part.
std::vector<int> onlyActive(std::vector<int> now, const std::vector<int>& active) {
    auto next = active.begin();
    for (int& i : now) {
        next = std::lower_bound(next, active.end(), i);
        if (i >= 0 && (next == active.end() || *next != i)) i = -1;
    }
    return now;
}

}  // namespace

Triangulation<3> spaceDelaunay(const Points<3>& points, const std::vector<int>& active, bool* coincide) {
    std::vector<std::pair<Kernel::Point_3, int>> input;
    for (const int i : active) input.push_back({{points[i][0], points[i][1], points[i][2]}, i});
    const Delaunay triangulation(input.begin(), input.end());
    if (coincide) *coincide = triangulation.number_of_vertices() < active.size();
    Triangulation<3> result;
    if (triangulation.dimension() < 3) return result;
    const auto cells = sortedCells(triangulation, points.size());
    parallelFor(static_cast<int>(cells.size()), [&](int e) { cells[e].cell->info() = e; });
    result.cells.resize(cells.size());
    result.neighbours.resize(cells.size());
    parallelFor(static_cast<int>(cells.size()), [&](int e) {
        result.cells[e] = cells[e].nodes;
        for (int k = 0; k < 4; ++k) result.neighbours[e][k] = cells[e].cell->neighbor(cells[e].local[k])->info();
    });
    return result;
}

template <>
struct Triangulator<3>::Kept {
    Triangulation<3> last;
    std::vector<Id> ids;  // of its points

    /// The number now of each of its points, which keep their order; -1: gone.
    std::vector<int> numbersNow(const std::vector<Id>& idsNow) const {
        std::vector<int> now(ids.size(), -1);
        std::size_t k = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            while (k < idsNow.size() && idsNow[k] < ids[i]) ++k;
            if (k < idsNow.size() && idsNow[k] == ids[i]) now[i] = static_cast<int>(k++);
        }
        return now;
    }
};

template <>
Triangulator<3>::Triangulator(Ranks ranks, double halo) : ranks_(ranks), halo_(halo), kept_(std::make_unique<Kept>()) {}
template <>
Triangulator<3>::~Triangulator() = default;
template <>
Triangulator<3>::Triangulator(Triangulator&&) noexcept = default;
template <>
Triangulator<3>& Triangulator<3>::operator=(Triangulator&&) noexcept = default;

template <>
void Triangulator<3>::follow(const Points<3>& points, const std::vector<Id>& ids, const std::vector<int>& active,
                             const std::vector<Face<3>>&, const std::vector<Face<3>>&) {
    Triangulation<3>& last = kept_->last;
    std::vector<int> now;  // of those that take part
    if (halo_ > 0 && !last.cells.empty()) now = onlyActive(kept_->numbersNow(ids), active);
    kept_->ids = ids;
    if (auto mended = now.empty() ? std::nullopt : mendedDelaunay(points, active, last, now, halo_)) {
        last = *std::move(mended);
        return;
    }
    if (!ranks_.isAlone()) {
        last = sharedDelaunay(points, active, ranks_, halo_);
        return;
    }
    const int nThreads = halo_ > 0 ? std::min(omp_get_max_threads(), static_cast<int>(active.size() / leastPart)) : 1;
    auto byThreads = nThreads > 1 ? threadedDelaunay(points, active, nThreads, halo_) : std::nullopt;
    last = byThreads ? *std::move(byThreads) : spaceDelaunay(points, active);
}

template <>
const Triangulation<3>& Triangulator<3>::triangulation(int) {
    return kept_->last;
}

}  // namespace pfem
