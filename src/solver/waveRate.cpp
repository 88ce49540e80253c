#include "solver/waveRate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"

namespace pfem {

namespace {

/// Least h of a cell's nodes.
template <int Dim>
double leastSize(const Nodes<Dim>& nodes, const Simplex<Dim>& cell) {
    double h = std::numeric_limits<double>::infinity();
    for (const int node : cell) h = std::min(h, nodes.h[node]);
    return h;
}

}  // namespace

template <int Dim>
double gravityWaveRate(const Problem<Dim>& problem, const State<Dim>& state) {
    const int n = state.mesh.fluid.size();
    double h = std::numeric_limits<double>::infinity();
#pragma omp parallel for schedule(static) reduction(min : h) if (n > shortLoop)
    for (int e = 0; e < n; ++e) h = std::min(h, leastSize<Dim>(state.nodes, state.mesh.fluid.nodes[e]));
    return std::sqrt(problemAt<Dim>(state.time.value, problem).gravity.norm() / h);
}

template <int Dim>
double elasticWaveRate(const Problem<Dim>& problem, const State<Dim>& state) {
    double rate = 0;
    for (int e = 0; e < state.mesh.solid.size(); ++e) {
        const Solid& solid = problem.solid(state.mesh.solid.material[e]);
        const auto [E, nu] = solid.elastic;
        const double modulus = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
        rate = std::max(rate, std::sqrt(modulus / solid.rho) / leastSize<Dim>(state.nodes, state.mesh.solid.nodes[e]));
    }
    return rate;
}

#define PFEM_INSTANTIATE(D)                                                 \
    template double gravityWaveRate<D>(const Problem<D>&, const State<D>&); \
    template double elasticWaveRate<D>(const Problem<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
