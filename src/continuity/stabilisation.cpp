#include "continuity/stabilisation.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "state/calm.hpp"

namespace pfem {

template <int Dim>
PerCell<double> stabilisation(const Problem<Dim>& problem, const Cells<Dim>& cells,
                              const SmoothingDomains<Dim>& domains, const PerCell<double>& mu, const Points<Dim>& v,
                              double dt) {
    PerCell<double> tau(cells.size());
    domains.share.forCells(cells.size(), [&](int e) {
        const ViscousFluid& fluid = problem.fluid(cells.material[e]);
        const double h =
            Dim == 2 ? std::sqrt(2 * domains.element[e].measure) : std::cbrt(6 * domains.element[e].measure);
        Vec<Dim> mean = Vec<Dim>::Zero();
        for (int node : cells.nodes[e]) mean += v[node] / (Dim + 1);
        tau[e] = sliverFactor<Dim>(domains.element[e]) /
                 (8 * mu[e] / (h * h) + fluid.rho / dt + fluid.rho * mean.norm() / h);
    });
    return tau;
}

template <int Dim>
double surfaceStabilisation(double tau, double mu, double cellMeasure, double faceMeasure) {
    const double height = Dim * cellMeasure / faceMeasure;
    return 1 / std::max(1 / tau, 4 * (Dim + 1) * mu / (height * height));
}

namespace {

/// Slow beside the waves of a triangle's length: |v|^2 < g h/10 for all of its nodes.
template <int Dim>
bool isCalm(const Problem<Dim>& problem, const Nodes<Dim>& nodes, const Simplex<Dim>& cell) {
    const double g = problem.gravity.norm();
    return std::all_of(cell.begin(), cell.end(),
                       [&](int i) { return nodes.v[i].squaredNorm() < calmSpeedSquared(g, nodes.h[i]); });
}

}  // namespace

template <int Dim>
PerCell<unsigned char> projectedCells(const ContinuityControls& controls, const Problem<Dim>& problem,
                                      const Cells<Dim>& cells, const Topology<Dim>& topology, const Nodes<Dim>& nodes) {
    PerCell<unsigned char> projected(cells.size(), 0);
    if (controls.stabilisation != "projection") return projected;
    const auto bounded = [&](int i) { return topology.onWall[i] || !topology.ofFluid(i); };
    std::vector<unsigned char> inside(topology.nNodes()),
        besideInside(topology.nNodes());  // of the fluid; on a wall or solid beside such a one
    parallelFor(topology.nNodes(), [&](int i) { inside[i] = !topology.freeSurface[i] && !bounded(i); });
    parallelFor(topology.nNodes(), [&](int i) {
        if (!bounded(i)) return;
        for (int s = topology.ring.start[i]; s < topology.ring.start[i + 1]; ++s)
            besideInside[i] |= inside[topology.ring.node[s]];
    });
    const auto has = [&](int e, const auto& property) {
        return std::any_of(cells.nodes[e].begin(), cells.nodes[e].end(), property);
    };
    parallelFor(cells.size(), [&](int e) {
        const bool contactLine = has(e, [&](int i) { return topology.freeSurface[i] && bounded(i); }) &&
                                 has(e, [&](int i) { return besideInside[i]; });
        if (has(e, [&](int i) { return topology.onSolid[i]; }))
            projected[e] = contactLine && isCalm<Dim>(problem, nodes, cells.nodes[e]);
        else if (contactLine)
            projected[e] = true;
        else  // films and tips have no node inside
            projected[e] = has(e, [&](int i) { return inside[i]; });
    });
    return projected;
}

#define PFEM_INSTANTIATE(D)                                                                                          \
    template PerCell<unsigned char> projectedCells<D>(const ContinuityControls&, const Problem<D>&, const Cells<D>&, \
                                                      const Topology<D>&, const Nodes<D>&);                          \
    template double surfaceStabilisation<D>(double, double, double, double);                                         \
    template PerCell<double> stabilisation<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&,        \
                                              const PerCell<double>&, const Points<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
