#include "solver/courantRate.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "mesh/topology.hpp"
#include "solver/flight.hpp"

namespace pfem {

template <int Dim>
double closingRate(const Nodes<Dim>& nodes, const std::vector<Simplex<Dim>>& simplices, double leastHeight) {
    double largest = 0;
    for (const auto& s : simplices) {
        if (isSliver<Dim>(nodes.x, s)) continue;
        double area = 0, h = 0;
        for (int k = 0; k <= Dim; ++k) {
            area = std::max(area, faceArea<Dim>(nodes.x, oppositeFace<Dim>(s, k)).norm());
            h += nodes.h[s[k]] / (Dim + 1);
        }
        const double height = Dim * simplexMeasure<Dim>(nodes.x, s) / area;
        const double least = leastHeight * h, flat = height >= least ? 1 : least > 0 ? height / least : 0;
        largest = std::max(largest, -simplexDivergence<Dim>(nodes.x, nodes.v, s) * flat);
    }
    return largest;
}

template <int Dim>
CourantRate courantRate(const State<Dim>& state) {
    const auto& nodes = state.nodes;
    CourantRate rate;
    const auto drops = looseNodes<Dim>(state.mesh, nodes.size());
    int counted = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        if (drops[i]) continue;
        const double own = nodes.v[i].norm() / nodes.h[i];
        rate.largest = std::max(rate.largest, own);
        rate.mean += own;
        ++counted;
    }
    if (counted > 0) rate.mean /= counted;
    for (int i = 0; i < nodes.size(); ++i)  // slower ones cannot be the first
        if (drops[i] && nodes.v[i].norm() > rate.largest * nodes.h[i])
            rate.largest = std::max(rate.largest, strikingRate<Dim>(state, drops, i));
    double squared = 0, compression = 0;
    const int nCells = state.mesh.fluid.size();
#pragma omp parallel for schedule(static) reduction(max : squared, compression) if (nCells > shortLoop)
    for (int e = 0; e < nCells; ++e) {
        const auto& s = state.mesh.fluid.nodes[e];
        for (int a = 1; a <= Dim; ++a)
            for (int b = 0; b < a; ++b) {
                const double h = std::min(nodes.h[s[a]], nodes.h[s[b]]);
                squared = std::max(squared, (nodes.v[s[a]] - nodes.v[s[b]]).squaredNorm() / (h * h));
            }
        if (!isSliver<Dim>(nodes.x, s))
            compression = std::max(compression, -simplexDivergence<Dim>(nodes.x, nodes.v, s));
    }
    rate.compression = std::max(compression, state.approach);
    rate.relative = std::sqrt(squared);
    return rate;
}

#define PFEM_INSTANTIATE(D)                               \
    template CourantRate courantRate<D>(const State<D>&); \
    template double closingRate<D>(const Nodes<D>&, const std::vector<Simplex<D>>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
