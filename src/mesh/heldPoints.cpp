#include "mesh/heldPoints.hpp"

#include <cmath>

#include "base/parallel.hpp"
#include "mesh/bins.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

/// The points are put into bins, about as many as points, and each cell looks into those that it touches: there are
/// more cells than points, and most find none.
template <int Dim>
std::vector<unsigned char> heldPoints(const Points<Dim>& x, const std::vector<Simplex<Dim>>& cells,
                                      const Points<Dim>& points) {
    const int n = static_cast<int>(points.size());
    std::vector<unsigned char> held(n, 0);
    if (cells.empty() || n == 0) return held;
    Vec<Dim> low = points[0], high = low;
    for (const auto& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    Bins<Dim> bins(low, high, (high - low).maxCoeff() / std::pow(n, 1.0 / Dim));
    for (int p = 0; p < n; ++p) bins.add(p, points[p], points[p]);
    pfem::parallelFor(static_cast<int>(cells.size()), [&](int e) {
        Vec<Dim> from = x[cells[e][0]], to = from;
        for (const int node : cells[e]) {
            from = from.cwiseMin(x[node]);
            to = to.cwiseMax(x[node]);
        }
        const Vec<Dim> margin = 1e-9 * (to - from);  // holds() has its tolerance, too
        from -= margin;
        to += margin;
        if ((from.array() > high.array()).any() || (to.array() < low.array()).any()) return;
        bins.parallelFor(from, to, [&](int p) {
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
