#include "momentum/fluidStress.hpp"

namespace pfem {

namespace {

template <int Dim>
Tensor<Dim> viscousStress(double mu, const Tensor<Dim>& L) {
    return mu * (L + L.transpose()) - (2 * mu / 3) * L.trace() * Tensor<Dim>::Identity();
}

}  // namespace

template <int Dim>
std::vector<Tensor<Dim>> fluidTangentStress(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                            const Patches<Dim>& patches, const Points<Dim>& dv,
                                            const std::vector<double>& bulk) {
    // the viscosity is linear, so the mean of the points' stresses is the stress of the mean gradient of each cell
    auto L = toPoints<Dim>(patches, elementGradient<Dim>(patches, dv));
    std::vector<double> volumetric(bulk.size());
    for (std::size_t p = 0; p < bulk.size(); ++p) volumetric[p] = bulk[p] * L[p].trace();
    if (!bulk.empty()) volumetric = fromPoints<Dim>(patches, std::move(volumetric));
    auto stress = fromPoints<Dim>(patches, std::move(L));
#pragma omp parallel for schedule(static)
    for (int e = 0; e < patches.nCells(); ++e) {
        stress[e] = viscousStress<Dim>(problem.fluid(cells.material[e]).mu, stress[e]);
        if (!volumetric.empty()) stress[e] += volumetric[e] * Tensor<Dim>::Identity();
    }
    return stress;
}

template <int Dim>
std::vector<Tensor<Dim>> fluidStress(const Problem<Dim>& problem, const Cells<Dim>& cells,
                                     const Patches<Dim>& patches, const Points<Dim>& v,
                                     const std::vector<double>& p) {
    auto stress = fluidTangentStress<Dim>(problem, cells, patches, v, {});
#pragma omp parallel for schedule(static)
    for (int e = 0; e < patches.nCells(); ++e) {
        stress[e] -= cellMean<Dim>(patches, p, e) * Tensor<Dim>::Identity();
    }
    return stress;
}

template std::vector<Tensor<2>> fluidStress<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&,
                                               const Points<2>&, const std::vector<double>&);
template std::vector<Tensor<2>> fluidTangentStress<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&,
                                                      const Points<2>&, const std::vector<double>&);

}  // namespace pfem
