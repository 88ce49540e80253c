#include "momentum/mass.hpp"

#include <algorithm>

#include "material/rigid.hpp"

namespace pfem {

namespace {

/// sum_e rho_e |e|/(d+1) in positions x. `density`: of a material.
template <int Dim, class Density>
std::vector<double> nodalShares(const Cells<Dim>& cells, const Points<Dim>& x, Density density) {
    std::vector<double> mass(x.size(), 0.0);
    for (int e = 0; e < cells.size(); ++e) {
        const double share = density(cells.material[e]) * simplexMeasure<Dim>(x, cells.nodes[e]) / (Dim + 1);
        for (int node : cells.nodes[e]) mass[node] += share;
    }
    return mass;
}

}  // namespace

template <int Dim>
PerNode<double> fluidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains) {
    const NodeToCells& around = *domains.around;
    std::vector<double> mass(domains.nNodes(), 0.0);
    const auto isFluid = [](const Material& m) { return m.kind == MaterialKind::fluid; };
    if (std::count_if(problem.materials.begin(), problem.materials.end(), isFluid) == 1) {
        const double rho = firstFluid(problem.materials)->rho;
        domains.share.forNodes(domains.nNodes(), [&](int i) { mass[i] = rho * domains.volume[i]; });
        return mass;
    }
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const int e = around.cell[s];
            mass[i] += problem.fluid(cells.material[e]).rho * domains.element[e].measure;
        }
        mass[i] /= Dim + 1;
    });
    return mass;
}

template <int Dim>
PerNode<double> fluidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const Points<Dim>& x) {
    return nodalShares<Dim>(cells, x, [&](int material) { return problem.fluid(material).rho; });
}

template <int Dim>
PerNode<double> solidMass(const Problem<Dim>& problem, const Cells<Dim>& cells, const Points<Dim>& X) {
    return nodalShares<Dim>(cells, X, [&](int material) {
        const Solid& solid = problem.solid(material);
        return rigidOf(solid.law.get()) ? 0 : solid.rho;
    });
}

#define PFEM_INSTANTIATE(D)                                                                                \
    template PerNode<double> fluidMass<D>(const Problem<D>&, const Cells<D>&, const Points<D>&);           \
    template PerNode<double> fluidMass<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&); \
    template PerNode<double> solidMass<D>(const Problem<D>&, const Cells<D>&, const Points<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
