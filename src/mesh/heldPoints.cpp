#include "mesh/heldPoints.hpp"

#include "base/parallel.hpp"
#include "mesh/pointTree.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

/// Each cell looks for the points in its box: there are more cells than points, and most find none.
template <int Dim>
std::vector<unsigned char> heldPoints(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells,
                                      const Points<Dim>& points) {
    std::vector<unsigned char> held(points.size(), 0);
    const PointTree<Dim> tree(points);
    parallelFor(static_cast<int>(cells.size()), [&](int e) {
        Vec<Dim> from = x[cells[e][0]], to = from;
        for (const int node : cells[e]) {
            from = from.cwiseMin(x[node]);
            to = to.cwiseMax(x[node]);
        }
        const Vec<Dim> margin = 1e-9 * (to - from);  // holds() has its tolerance, too
        from -= margin;
        to += margin;
        tree.forEachIn(from, to, [&](int p) {
            if (!holds<Dim>(x, cells[e], points[p]) || !(simplexMeasure<Dim>(x, cells[e]) > 0)) return;
#pragma omp atomic write
            held[p] = 1;
        });
    });
    return held;
}

template std::vector<unsigned char> heldPoints<2>(const Points<2>&, const std::vector<Simplex<2>>&, const Points<2>&);
template std::vector<unsigned char> heldPoints<3>(const Points<3>&, const std::vector<Simplex<3>>&, const Points<3>&);

}  // namespace pfem
