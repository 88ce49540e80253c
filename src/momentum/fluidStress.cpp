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
    // the viscosity is linear, so the mean of nodal stresses is the stress of the mean gradient of each cell
    auto L = nodalMean<Dim>(patches, elementGradient<Dim>(patches, dv));
    auto stress = elementMean<Dim>(patches, L);
#pragma omp parallel for schedule(static)
    for (int e = 0; e < patches.nCells(); ++e) {
        double volumetric = 0;
        if (!bulk.empty())
            for (int node : patches.cell(e)) volumetric += bulk[node] * L[node].trace() / (Dim + 1);
        stress[e] = viscousStress<Dim>(problem.fluid(cells.material[e]).mu, stress[e]) +
                    volumetric * Tensor<Dim>::Identity();
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
        double mean = 0;
        for (int node : patches.cell(e)) mean += p[node] / (Dim + 1);
        stress[e] -= mean * Tensor<Dim>::Identity();
    }
    return stress;
}

template std::vector<Tensor<2>> fluidStress<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&,
                                               const Points<2>&, const std::vector<double>&);
template std::vector<Tensor<2>> fluidTangentStress<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&,
                                                      const Points<2>&, const std::vector<double>&);

}  // namespace pfem
