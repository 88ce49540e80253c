#include "momentum/fluidStress.hpp"

#include <algorithm>
#include <utility>

#include "integration/materialRuns.hpp"
#include "material/viscosity.hpp"

namespace pfem {

template <int Dim>
bool isNewtonian(const Problem<Dim>& problem) {
    return std::all_of(problem.materials.begin(), problem.materials.end(), [](const Material& m) {
        return m.kind != MaterialKind::fluid || !m.fluid.law->dependsOnFlow();
    });
}

template <int Dim>
FlowViscosity<Dim> flowViscosity(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                 const SmoothingDomains<Dim>& domains, const Points<Dim>& v, const PerNode<double>& p) {
    const int n = nStressPoints<Dim>(domains);
    FlowViscosity<Dim> result;
    result.mu.assign(n, 0.0);
    const bool depends = !isNewtonian<Dim>(problem);
    PerPoint<double> g, pressure;
    if (depends) {
        result.rate = toPoints<Dim>(domains, elementGradient<Dim>(domains, v));
        result.softening.assign(n, 0.0);
        g.resize(n);
        pressure.resize(n);
    }
    const Share share = depends ? domains.share : Share();  // cells at its rim ask for nodes beyond it
    forMaterialRuns<Dim>(domains, share, cells, [&](int material, int first, int last) {
        const FluidLaw& law = *problem.fluid(material).law;
        if (!depends) {
            std::fill(result.mu.begin() + first, result.mu.begin() + last, law.viscosity(0, 0));
            return;
        }
        for (int i = first; i < last; ++i) {
            g[i] = shearRate<Dim>(result.rate[i]);
            pressure[i] = atPoint<Dim>(domains, p, i);
        }
        law.evaluate({runOf(std::as_const(g), first, last), runOf(std::as_const(pressure), first, last),
                      runOf(result.mu, first, last), runOf(result.softening, first, last)});
        for (int i = first; i < last; ++i) {
            const Tensor<Dim> L = result.rate[i];
            result.rate[i] = 0.5 * (L + L.transpose()) - L.trace() / 3 * Tensor<Dim>::Identity();
            result.softening[i] = g[i] > 0 ? 4 / g[i] * result.softening[i] : 0;
        }
    });
    return result;
}

template <int Dim>
PerCell<Tensor<Dim>> fluidTangentStress(const SmoothingDomains<Dim>& domains, const FlowViscosity<Dim>& viscosity,
                                        const Points<Dim>& dv, const PerPoint<double>& bulk) {
    auto stress = toPoints<Dim>(domains, elementGradient<Dim>(domains, dv));
    forPoints<Dim>(domains, [&](int p) {
        const Tensor<Dim> L = stress[p];
        stress[p] = viscousStress<Dim>(viscosity.mu[p], L);
        if (!viscosity.rate.empty()) {
            // d' : dd', the zz component of plane strain included: d' : dd as d' has no trace
            const Tensor<Dim>& rate = viscosity.rate[p];
            stress[p] += viscosity.softening[p] * rate.cwiseProduct(L).sum() * rate;
        }
        if (!bulk.empty()) stress[p] += bulk[p] * L.trace() * Tensor<Dim>::Identity();
    });
    return fromPoints<Dim>(domains, std::move(stress));
}

template <int Dim>
Points<Dim> viscousForce(const SmoothingDomains<Dim>& domains, const PerPoint<double>& mu,
                         const VelocityGradients<Dim>& L) {
    PerPoint<Tensor<Dim>> stress(nStressPoints<Dim>(domains));
    forPoints<Dim>(domains, [&](int p) { stress[p] = viscousStress<Dim>(mu[p], atPoint<Dim>(domains, L, p)); });
    Points<Dim> force(domains.nNodes(), Vec<Dim>::Zero());
    addInternalForce<Dim>(domains, fromPoints<Dim>(domains, std::move(stress)), force);
    return force;
}

template <int Dim>
PerPoint<double> tangentViscosity(const FlowViscosity<Dim>& viscosity) {
    PerPoint<double> mu = viscosity.mu;
    for (std::size_t p = 0; p < viscosity.rate.size(); ++p) {
        const Tensor<Dim>& d = viscosity.rate[p];
        mu[p] += 0.5 * viscosity.softening[p] * (d.squaredNorm() + d.trace() * d.trace());
    }
    return mu;
}

template <int Dim>
Points<Dim> zigzagForce(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                        double damping, const PerNode<double>& h, const VelocityGradients<Dim>& L) {
    Points<Dim> force(domains.nNodes(), Vec<Dim>::Zero());
    const double g = problem.gravity.norm();
    if (damping == 0 || g == 0 || domains.nCells() == 0) return force;
    auto stress = elementMean<Dim>(domains, L.nodal);
    domains.share.forCells(domains.nCells(), [&](int e) {
        const double size = cellMean<Dim>(domains, h, e);
        const double mu = damping * problem.fluid(cells.material[e]).rho * size * std::sqrt(g * size);
        const Tensor<Dim> zigzag = L.element[e] - stress[e];
        stress[e] = sliverFactor<Dim>(domains.element[e]) * mu * (zigzag + zigzag.transpose());
    });
    addInternalForce<Dim>(domains, stress, force);
    return force;
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template Points<D> zigzagForce<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&, double,  \
                                      const PerNode<double>&, const VelocityGradients<D>&);                    \
    template bool isNewtonian<D>(const Problem<D>&);                                                           \
    template PerPoint<double> tangentViscosity<D>(const FlowViscosity<D>&);                                    \
    template FlowViscosity<D> flowViscosity<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&, \
                                               const Points<D>&, const PerNode<double>&);                      \
    template Points<D> viscousForce<D>(const SmoothingDomains<D>&, const PerPoint<double>&,                    \
                                       const VelocityGradients<D>&);                                           \
    template PerCell<Tensor<D>> fluidTangentStress<D>(const SmoothingDomains<D>&, const FlowViscosity<D>&,     \
                                                      const Points<D>&, const PerPoint<double>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
