#include "solver/fluidEnergy.hpp"

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "momentum/consistentMass.hpp"
#include "state/images.hpp"

namespace pfem {

namespace {

/// v^2/2 - g . x of a node, without what a frame adds to g.
template <int Dim>
double specificEnergy(const Problem<Dim>& problem, const Nodes<Dim>& nodes, int i) {
    return 0.5 * nodes.v[i].squaredNorm() - problem.gravityOutside().dot(nodes.x[i]);
}

}  // namespace

template <int Dim>
StoredEnergy fluidEnergy(const Problem<Dim>& problem, const State<Dim>& state, FluidMass mass) {
    const auto& nodes = state.nodes;
    const auto& cells = state.mesh.fluid;
    const Vec<Dim> gravity = problem.gravityOutside();
    StoredEnergy energy = parallelSum(nOwnCells<Dim>(state), [&](int e) {
        const ViscousFluid& fluid = problem.fluid(cells.material[e]);
        double squaredSpeed = 0, height = 0, squaredPressure = 0;
        for (const int i : cells.nodes[e]) {
            squaredSpeed += nodes.v[i].squaredNorm();
            height -= gravity.dot(nodes.x[i]);
            squaredPressure += nodes.p[i] * nodes.p[i];
        }
        if (mass == FluidMass::consistent) squaredSpeed += squaredSpeedDifference<Dim>(cells.nodes[e], nodes.v);
        const double share = simplexMeasure<Dim>(nodes.x, cells.nodes[e]) / (Dim + 1);
        return StoredEnergy{0.5 * share * fluid.rho * squaredSpeed, 0.5 * share * squaredPressure / fluid.kappa,
                            share * fluid.rho * height};
    });
    const ViscousFluid* first = firstFluid(problem.materials);
    const int n = first ? nOwnNodes<Dim>(state) : 0;
    for (int i = 0; i < n; ++i) {
        const double ofDrop = first->rho * nodes.dropVolume[i];
        energy.kinetic += 0.5 * ofDrop * nodes.v[i].squaredNorm();
        energy.potential -= ofDrop * gravity.dot(nodes.x[i]);
    }
    return energy;
}

template <int Dim>
double volumeEnergy(const Problem<Dim>& problem, const Cells<Dim>& cells, const Nodes<Dim>& old, const Nodes<Dim>& now,
                    const std::vector<double>& returned, FluidMass mass) {
    double sum = parallelSum(cells.size(), [&](int e) {
        const double change = simplexMeasure<Dim>(now.x, cells.nodes[e]) - simplexMeasure<Dim>(old.x, cells.nodes[e]);
        double ofNodes = 0;
        for (const int i : cells.nodes[e])
            ofNodes += 0.5 * (specificEnergy<Dim>(problem, old, i) + specificEnergy<Dim>(problem, now, i));
        if (mass == FluidMass::consistent)
            for (const auto* nodes : {&old, &now})
                ofNodes += 0.25 * squaredSpeedDifference<Dim>(cells.nodes[e], nodes->v);
        return problem.fluid(cells.material[e]).rho * change / (Dim + 1) * ofNodes;
    });
    for (int i = 0; i < now.size(); ++i) sum += now.p[i] * returned[i];
    return sum;
}

#define PFEM_INSTANTIATE(D)                                                                               \
    template StoredEnergy fluidEnergy<D>(const Problem<D>&, const State<D>&, FluidMass);                  \
    template double volumeEnergy<D>(const Problem<D>&, const Cells<D>&, const Nodes<D>&, const Nodes<D>&, \
                                    const std::vector<double>&, FluidMass);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
