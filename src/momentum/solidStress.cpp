#include "momentum/solidStress.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "material/hypoelastic.hpp"
#include "material/neoHookean.hpp"

namespace pfem {

namespace {

/// Element stress with the force of the energy sum_p Omega_p W(F_p), F_p over the reference patches: the mean of the
/// points' first Piola stress, carried to the current element by its own F_e. For elements: sigma itself.
template <int Dim>
std::vector<Tensor<Dim>> hyperelasticElementStress(const Patches<Dim>& reference, const std::vector<Stress<Dim>>& sigma,
                                                   const Points<Dim>& x) {
    const auto F = elementGradient<Dim>(reference, x);
    const auto pointF = toPoints<Dim>(reference, F);
    std::vector<Tensor<Dim>> P(sigma.size(), Tensor<Dim>::Zero());
    for (int p = 0; p < nStressPoints<Dim>(reference); ++p)
        if (isStressPoint<Dim>(reference, p)) P[p] = firstPiola<Dim>(sigma[p], pointF[p]);
    auto stress = fromPoints<Dim>(reference, std::move(P));
    for (int e = 0; e < reference.nCells(); ++e) stress[e] *= F[e].transpose() / F[e].determinant();
    return stress;
}

template <int Dim>
std::vector<Tensor<Dim>> cauchyElementStress(const Patches<Dim>& patches, const std::vector<Stress<Dim>>& sigma) {
    std::vector<Tensor<Dim>> point(sigma.size());
    forEach(static_cast<int>(sigma.size()), [&](int p) { point[p] = stressTensor<Dim>(sigma[p]); });
    return fromPoints<Dim>(patches, std::move(point));
}

}  // namespace

double dampingTime(const Hypoelastic& material, double alpha, double h) {
    return alpha * h * std::sqrt(material.rho / material.E);
}

bool splitsEnergy(const SolidControls& controls) {
    return controls.formulation == "velocityPressure" && controls.stressUpdate == "neoHookean";
}

template <int Dim>
const Hypoelastic& solidMaterial(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                                 int point) {
    return problem.solid(cells.material[cellOfPoint<Dim>(patches, point)]);
}

template <int Dim>
Points<Dim> gradientPositions(const SolidControls& controls, const Nodes<Dim>& old, const Nodes<Dim>& trial) {
    if (controls.stressUpdate == "paper") return trial.x;
    if (controls.stressUpdate == "neoHookean") return trial.X;
    Points<Dim> middle(old.x.size());
    forEach(old.size(), [&](int i) { middle[i] = 0.5 * (old.x[i] + trial.x[i]); });
    return middle;
}

namespace {

/// sigma^{n+1} at the stress points by the law that the user has chosen.
template <int Dim>
std::vector<Stress<Dim>> updatedStress(const Problem<Dim>& problem, const SolidControls& controls,
                                       const Cells<Dim>& cells, const Patches<Dim>& patches, const Nodes<Dim>& old,
                                       const Nodes<Dim>& trial, double dt) {
    auto sigma = storedAtPoints<Dim>(patches, old.sigma, cells.sigma);
    if (patches.nCells() == 0) return sigma;
    const auto update = [&](const Points<Dim>& field, const auto& law) {
        const auto gradient = toPoints<Dim>(patches, elementGradient<Dim>(patches, field));
        forEach(nStressPoints<Dim>(patches), [&](int p) {
            if (isStressPoint<Dim>(patches, p))
                sigma[p] = law(solidMaterial<Dim>(problem, cells, patches, p), sigma[p], gradient[p]);
        });
    };
    using Law = const Hypoelastic&;
    using Old = const Stress<Dim>&;
    using Gradient = const Tensor<Dim>&;
    const bool split = splitsEnergy(controls);
    if (controls.stressUpdate == "paper") {
        update(trial.v, [&](Law m, Old s, Gradient L) { return paperUpdate<Dim>(m, s, L, dt); });
    } else if (controls.stressUpdate == "neoHookean") {
        update(trial.x, [&](Law m, Old, Gradient F) {
            return m.law != nullptr ? lawTotal<Dim>(*m.law, F)
                   : split          ? neoHookeanShear<Dim>(m, F)
                                    : neoHookeanStress<Dim>(m, F);
        });
    } else {
        Points<Dim> increment(old.x.size());
        forEach(old.size(), [&](int i) {  // x - x^n without its cancellation
            increment[i] = 0.5 * dt * (old.v[i] + trial.v[i]);
        });
        update(increment, [](Law m, Old s, Gradient du) {
            return m.law != nullptr ? lawMidpoint<Dim>(*m.law, s, du) : rotatedMidpoint<Dim>(m, s, du);
        });
    }
    return sigma;
}

}  // namespace

template <int Dim>
std::vector<double> volumeRatio(const Patches<Dim>& reference, const Points<Dim>& x) {
    const NodeToCells& around = *reference.around;
    std::vector<double> J(reference.nNodes(), 1.0);
    for (int i = 0; i < reference.nNodes(); ++i) {
        if (around.count(i) == 0) continue;
        double volume = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            volume += simplexMeasure<Dim>(x, reference.cell(around.cell[s]));
        J[i] = volume / ((Dim + 1) * reference.volume[i]);
    }
    return J;
}

template <int Dim>
SolidStress<Dim> solidStress(const Problem<Dim>& problem, const SolidControls& controls, const Cells<Dim>& cells,
                             const Patches<Dim>& patches, const Nodes<Dim>& old, const Nodes<Dim>& trial, double dt) {
    SolidStress<Dim> stress;
    stress.point = updatedStress<Dim>(problem, controls, cells, patches, old, trial, dt);
    if (controls.formulation == "velocity") return stress;
    if (splitsEnergy(controls)) {
        stress.pressure = volumeRatio<Dim>(patches, trial.x);
        const auto nodes = withNodalPoints<Dim>(patches);
        for (int i = 0; i < nodes.nNodes(); ++i)
            stress.pressure[i] =
                isStressPoint<Dim>(nodes, i)
                    ? neoHookeanPressure(solidMaterial<Dim>(problem, cells, nodes, i), stress.pressure[i])
                    : 0;
        return stress;
    }
    const auto atNodes = updatedStress<Dim>(problem, controls, cells, withNodalPoints<Dim>(patches), old, trial, dt);
    for (auto& sigma : stress.point) sigma = deviator<Dim>(sigma);
    for (int i = 0; i < patches.nNodes(); ++i)
        stress.pressure.push_back(patches.around->count(i) > 0 ? pressure<Dim>(atNodes[i]) : 0);
    return stress;
}

template <int Dim>
std::vector<Tensor<Dim>> solidElementStress(const Problem<Dim>& problem, const SolidControls& controls,
                                            const Cells<Dim>& cells, const Patches<Dim>& patches,
                                            const Patches<Dim>& end, const SolidStress<Dim>& stress,
                                            const Nodes<Dim>& trial) {
    if (end.nCells() == 0) return {};
    auto sum = controls.stressUpdate == "neoHookean" ? hyperelasticElementStress<Dim>(patches, stress.point, trial.x)
                                                     : cauchyElementStress<Dim>(end, stress.point);
    const auto L = elementGradient<Dim>(end, trial.v);
    const auto mean = fromPoints<Dim>(end, toPoints<Dim>(end, L));
    for (int e = 0; e < end.nCells(); ++e) {
        const Hypoelastic& material = problem.solid(cells.material[e]);
        const Tensor<Dim> zigzag = L[e] - mean[e];
        sum[e] += dampingTime(material, controls.damping, cellMean<Dim>(end, trial.h, e)) *
                  stressTensor<Dim>(elasticStress<Dim>(material, 0.5 * (zigzag + zigzag.transpose())));
        if (!stress.pressure.empty()) sum[e] -= cellMean<Dim>(end, stress.pressure, e) * Tensor<Dim>::Identity();
    }
    return sum;
}

template <int Dim>
std::vector<Tensor<Dim>> storedElementStress(const Problem<Dim>& problem, const SolidControls& controls,
                                             const Cells<Dim>& cells, const Patches<Dim>& patches,
                                             const Nodes<Dim>& nodes) {
    auto gradients = patches;
    updatePatches<Dim>(gradients, gradientPositions<Dim>(controls, nodes, nodes));
    // a hyperelastic stress follows from the positions; the others are what is stored
    const SolidStress<Dim> stress = controls.stressUpdate == "neoHookean"
                                        ? solidStress<Dim>(problem, controls, cells, gradients, nodes, nodes, 0)
                                        : SolidStress<Dim>{storedAtPoints<Dim>(patches, nodes.sigma, cells.sigma), {}};
    return solidElementStress<Dim>(problem, controls, cells, gradients, patches, stress, nodes);
}

template <int Dim>
void storeSolidStress(const Patches<Dim>& patches, SolidStress<Dim> stress, std::vector<Stress<Dim>>& nodal,
                      std::vector<Stress<Dim>>& cell) {
    storeFromPoints<Dim>(patches, std::move(stress.point), nodal, cell);
    if (stress.pressure.empty()) return;
    for (std::size_t i = 0; i < nodal.size(); ++i) nodal[i] = withPressure<Dim>(nodal[i], stress.pressure[i]);
    for (std::size_t e = 0; e < cell.size(); ++e)
        cell[e] = withPressure<Dim>(cell[e], cellMean<Dim>(patches, stress.pressure, static_cast<int>(e)));
}

#define PFEM_INSTANTIATE(D)                                                                                            \
    template const Hypoelastic& solidMaterial<D>(const Problem<D>&, const Cells<D>&, const Patches<D>&, int);          \
    template std::vector<double> volumeRatio<D>(const Patches<D>&, const Points<D>&);                                  \
    template Points<D> gradientPositions<D>(const SolidControls&, const Nodes<D>&, const Nodes<D>&);                   \
    template SolidStress<D> solidStress<D>(const Problem<D>&, const SolidControls&, const Cells<D>&,                   \
                                           const Patches<D>&, const Nodes<D>&, const Nodes<D>&, double);               \
    template std::vector<Tensor<D>> solidElementStress<D>(const Problem<D>&, const SolidControls&, const Cells<D>&,    \
                                                          const Patches<D>&, const Patches<D>&, const SolidStress<D>&, \
                                                          const Nodes<D>&);                                            \
    template std::vector<Tensor<D>> storedElementStress<D>(const Problem<D>&, const SolidControls&, const Cells<D>&,   \
                                                           const Patches<D>&, const Nodes<D>&);                        \
    template void storeSolidStress<D>(const Patches<D>&, SolidStress<D>, std::vector<Stress<D>>&,                      \
                                      std::vector<Stress<D>>&);
PFEM_INSTANTIATE(2)

}  // namespace pfem
