#include "solver/energyLedger.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// v^2/2 - g . x of a node.
template <int Dim>
double specificEnergy(const Problem<Dim>& problem, const Nodes<Dim>& nodes, int i) {
    return 0.5 * nodes.v[i].squaredNorm() - problem.gravity.dot(nodes.x[i]);
}

}  // namespace

template <int Dim>
double fluidEnergy(const Problem<Dim>& problem, const State<Dim>& state) {
    const auto& nodes = state.nodes;
    const auto& cells = state.mesh.fluid;
    double sum = sumOver(cells.size(), [&](int e) {
        const ViscousFluid& fluid = problem.fluid(cells.material[e]);
        double ofNodes = 0;
        for (const int i : cells.nodes[e])
            ofNodes += fluid.rho * specificEnergy<Dim>(problem, nodes, i) + 0.5 * nodes.p[i] * nodes.p[i] / fluid.kappa;
        return simplexMeasure<Dim>(nodes.x, cells.nodes[e]) / (Dim + 1) * ofNodes;
    });
    const auto first = std::find_if(problem.materials.begin(), problem.materials.end(),
                                    [](const Material& m) { return m.kind == MaterialKind::fluid; });
    if (first == problem.materials.end()) return sum;
    for (int i = 0; i < nodes.size(); ++i)
        if (nodes.dropVolume[i] != 0) sum += first->fluid.rho * nodes.dropVolume[i] * specificEnergy<Dim>(problem, nodes, i);
    return sum;
}

template <int Dim>
double volumeEnergy(const Problem<Dim>& problem, const Cells<Dim>& cells, const Nodes<Dim>& old, const Nodes<Dim>& now,
                    const std::vector<double>& returned) {
    double sum = sumOver(cells.size(), [&](int e) {
        const double change = simplexMeasure<Dim>(now.x, cells.nodes[e]) - simplexMeasure<Dim>(old.x, cells.nodes[e]);
        double ofNodes = 0;
        for (const int i : cells.nodes[e])
            ofNodes += 0.5 * (specificEnergy<Dim>(problem, old, i) + specificEnergy<Dim>(problem, now, i));
        return problem.fluid(cells.material[e]).rho * change / (Dim + 1) * ofNodes;
    });
    for (int i = 0; i < now.size(); ++i) sum += now.p[i] * returned[i];
    return sum;
}

template double fluidEnergy<2>(const Problem<2>&, const State<2>&);
template double volumeEnergy<2>(const Problem<2>&, const Cells<2>&, const Nodes<2>&, const Nodes<2>&,
                                const std::vector<double>&);

}  // namespace pfem
