#include "solver/courantRate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "mesh/distance.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// How far a drop is from all that it could hit: nodes that are no drops, and faces of walls.
template <int Dim>
double distanceToHit(const State<Dim>& state, int drop) {
    const auto& nodes = state.nodes;
    double squared = std::numeric_limits<double>::max();
    for (int i = 0; i < nodes.size(); ++i)
        if (!(nodes.dropVolume[i] > 0)) squared = std::min(squared, (nodes.x[i] - nodes.x[drop]).squaredNorm());
    double distance = std::sqrt(squared);
    for (const auto& patch : state.mesh.patches)
        for (const auto& face : patch.faces) distance = std::min(distance, distanceToFace<Dim>(nodes.x, face, nodes.x[drop]));
    return distance;
}

}  // namespace

template <int Dim>
double closingRate(const Nodes<Dim>& nodes, const std::vector<Simplex<Dim>>& simplices, double leastHeight) {
    double largest = 0;
    for (const auto& s : simplices) {
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
    for (const bool drops : {false, true})
        for (int i = 0; i < nodes.size(); ++i) {
            if ((nodes.dropVolume[i] > 0) != drops) continue;
            double own = nodes.v[i].norm() / nodes.h[i];
            if (drops && own > rate.largest) own = nodes.v[i].norm() / (nodes.h[i] + distanceToHit<Dim>(state, i));
            rate.largest = std::max(rate.largest, own);
            rate.mean += own / nodes.size();
        }
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
        compression = std::max(compression, -simplexDivergence<Dim>(nodes.x, nodes.v, s));
    }
    rate.compression = std::max(compression, state.approach);
    rate.relative = std::sqrt(squared);
    return rate;
}

#define PFEM_INSTANTIATE(D)                              \
    template CourantRate courantRate<D>(const State<D>&); \
    template double closingRate<D>(const Nodes<D>&, const std::vector<Simplex<D>>&, double);
PFEM_INSTANTIATE(2)

}  // namespace pfem
