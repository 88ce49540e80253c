#include "momentum/fluidStress.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "material/viscosity.hpp"

namespace pfem {

template <int Dim>
bool isNewtonian(const Problem<Dim>& problem) {
    return std::all_of(problem.materials.begin(), problem.materials.end(),
                       [](const Material& m) { return m.kind != MaterialKind::fluid || m.fluid.isNewtonian(); });
}

template <int Dim>
FlowViscosity<Dim> flowViscosity(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                                 const Points<Dim>& v) {
    const int n = nStressPoints<Dim>(patches);
    FlowViscosity<Dim> result;
    result.mu.assign(n, 0.0);
    const bool depends = !isNewtonian<Dim>(problem);
    if (depends) {
        result.rate = toPoints<Dim>(patches, elementGradient<Dim>(patches, v));
        result.softening.assign(n, 0.0);
    }
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int p = 0; p < n; ++p) {
        if (!isStressPoint<Dim>(patches, p)) continue;
        const ViscousFluid& fluid = problem.fluid(cells.material[cellOfPoint<Dim>(patches, p)]);
        const double g = depends ? shearRate<Dim>(result.rate[p]) : 0;
        result.mu[p] = viscosity(fluid, g);
        if (!depends) continue;
        const Tensor<Dim> L = result.rate[p];
        result.rate[p] = 0.5 * (L + L.transpose()) - L.trace() / 3 * Tensor<Dim>::Identity();
        if (g > 0) result.softening[p] = 4 / g * viscositySlope(fluid, g);
    }
    return result;
}

template <int Dim>
std::vector<Tensor<Dim>> fluidTangentStress(const Patches<Dim>& patches, const FlowViscosity<Dim>& viscosity,
                                            const Points<Dim>& dv, const std::vector<double>& bulk) {
    auto stress = toPoints<Dim>(patches, elementGradient<Dim>(patches, dv));
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int p = 0; p < nStressPoints<Dim>(patches); ++p) {
        const Tensor<Dim> L = stress[p];
        stress[p] = viscousStress<Dim>(viscosity.mu[p], L);
        if (!viscosity.rate.empty()) {
            // d' : dd', the zz component of plane strain included: d' : dd as d' has no trace
            const Tensor<Dim>& rate = viscosity.rate[p];
            stress[p] += viscosity.softening[p] * rate.cwiseProduct(L).sum() * rate;
        }
        if (!bulk.empty()) stress[p] += bulk[p] * L.trace() * Tensor<Dim>::Identity();
    }
    return fromPoints<Dim>(patches, std::move(stress));
}

template <int Dim>
Points<Dim> viscousForce(const Patches<Dim>& patches, const std::vector<double>& mu, const Points<Dim>& v) {
    Points<Dim> force(patches.nNodes(), Vec<Dim>::Zero());
    addInternalForce<Dim>(patches, fluidTangentStress<Dim>(patches, {mu, {}, {}}, v, {}), force);
    return force;
}

template <int Dim>
std::vector<double> tangentViscosity(const FlowViscosity<Dim>& viscosity) {
    std::vector<double> mu = viscosity.mu;
    for (std::size_t p = 0; p < viscosity.rate.size(); ++p) {
        const Tensor<Dim>& d = viscosity.rate[p];
        mu[p] += 0.5 * viscosity.softening[p] * (d.squaredNorm() + d.trace() * d.trace());
    }
    return mu;
}

template <int Dim>
Points<Dim> zigzagForce(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                        double damping, const std::vector<double>& h, const Points<Dim>& v) {
    Points<Dim> force(patches.nNodes(), Vec<Dim>::Zero());
    const double g = problem.gravity.norm();
    if (damping == 0 || g == 0 || patches.nCells() == 0) return force;
    auto L = elementGradient<Dim>(patches, v);
    const auto nodal = withNodalPoints<Dim>(patches);
    const auto mean = fromPoints<Dim>(nodal, toPoints<Dim>(nodal, L));
    forEach(patches.nCells(), [&](int e) {
        const double size = cellMean<Dim>(patches, h, e);
        const double mu = damping * problem.fluid(cells.material[e]).rho * size * std::sqrt(g * size);
        const Tensor<Dim> zigzag = L[e] - mean[e];
        L[e] = mu * (zigzag + zigzag.transpose());
    });
    addInternalForce<Dim>(patches, L, force);
    return force;
}

template Points<2> zigzagForce<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&, double,
                                  const std::vector<double>&, const Points<2>&);
template bool isNewtonian<2>(const Problem<2>&);
template std::vector<double> tangentViscosity<2>(const FlowViscosity<2>&);
template FlowViscosity<2> flowViscosity<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&, const Points<2>&);
template Points<2> viscousForce<2>(const Patches<2>&, const std::vector<double>&, const Points<2>&);
template std::vector<Tensor<2>> fluidTangentStress<2>(const Patches<2>&, const FlowViscosity<2>&, const Points<2>&,
                                                      const std::vector<double>&);

}  // namespace pfem
