#include "momentum/fluidStress.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "material/viscosity.hpp"

namespace pfem {

template <int Dim>
bool isNewtonian(const Problem<Dim>& problem) {
    return std::all_of(problem.materials.begin(), problem.materials.end(), [](const Material& m) {
        return m.kind != MaterialKind::fluid || m.fluid.isNewtonian();
    });
}

template <int Dim>
std::vector<double> pointViscosity(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                                   const Points<Dim>& v) {
    std::vector<double> mu(nStressPoints<Dim>(patches), 0.0);
    std::vector<Tensor<Dim>> L;  // which a constant viscosity does not ask for
    if (!isNewtonian<Dim>(problem)) L = toPoints<Dim>(patches, elementGradient<Dim>(patches, v));
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int p = 0; p < nStressPoints<Dim>(patches); ++p) {
        if (!isStressPoint<Dim>(patches, p)) continue;
        const ViscousFluid& fluid = problem.fluid(cells.material[cellOfPoint<Dim>(patches, p)]);
        mu[p] = viscosity(fluid, L.empty() ? 0 : shearRate<Dim>(L[p]));
    }
    return mu;
}

template <int Dim>
std::vector<Tensor<Dim>> fluidTangentStress(const Patches<Dim>& patches, const std::vector<double>& mu,
                                            const Points<Dim>& dv, const std::vector<double>& bulk) {
    auto stress = toPoints<Dim>(patches, elementGradient<Dim>(patches, dv));
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int p = 0; p < nStressPoints<Dim>(patches); ++p) {
        const double div = stress[p].trace();
        stress[p] = viscousStress<Dim>(mu[p], stress[p]);
        if (!bulk.empty()) stress[p] += bulk[p] * div * Tensor<Dim>::Identity();
    }
    return fromPoints<Dim>(patches, std::move(stress));
}

template <int Dim>
std::vector<Tensor<Dim>> fluidStress(const Patches<Dim>& patches, const std::vector<double>& mu, const Points<Dim>& v,
                                     const std::vector<double>& p) {
    auto stress = fluidTangentStress<Dim>(patches, mu, v, {});
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int e = 0; e < patches.nCells(); ++e) stress[e] -= cellMean<Dim>(patches, p, e) * Tensor<Dim>::Identity();
    return stress;
}

template bool isNewtonian<2>(const Problem<2>&);
template std::vector<double> pointViscosity<2>(const Problem<2>&, const Cells<2>&, const Patches<2>&, const Points<2>&);
template std::vector<Tensor<2>> fluidStress<2>(const Patches<2>&, const std::vector<double>&, const Points<2>&,
                                               const std::vector<double>&);
template std::vector<Tensor<2>> fluidTangentStress<2>(const Patches<2>&, const std::vector<double>&, const Points<2>&,
                                                      const std::vector<double>&);

}  // namespace pfem
