#include "momentum/solidStress.hpp"

#include <cmath>

#include "material/hypoelastic.hpp"

namespace pfem {

double dampingTime(const Hypoelastic& material, double alpha, double h) {
    return alpha * h * std::sqrt(material.rho / material.E);
}

template <int Dim>
const Hypoelastic& solidMaterial(const Problem<Dim>& problem, const Cells<Dim>& cells, const NodeToCells& around,
                                 int node) {
    return problem.solid(cells.material[around.cell[around.start[node]]]);
}

template <int Dim>
std::vector<Stress<Dim>> solidStress(const Problem<Dim>& problem, const SolidControls& controls,
                                     const Cells<Dim>& cells, const Patches<Dim>& midpoint,
                                     const Patches<Dim>& end, const Nodes<Dim>& old, const Nodes<Dim>& trial,
                                     double dt) {
    const NodeToCells& around = *end.around;
    std::vector<Stress<Dim>> sigma = old.sigma;
    const bool paper = controls.stressUpdate == "paper";
    Points<Dim> increment(old.x.size());
    if (!paper)
        for (std::size_t i = 0; i < increment.size(); ++i)  // x - x^n without its cancellation
            increment[i] = 0.5 * dt * (old.v[i] + trial.v[i]);
    const auto gradient = paper ? nodalMean<Dim>(end, elementGradient<Dim>(end, trial.v))
                                : nodalMean<Dim>(midpoint, elementGradient<Dim>(midpoint, increment));
    for (int i = 0; i < end.nNodes(); ++i) {
        if (around.count(i) == 0) continue;
        const Hypoelastic& material = solidMaterial<Dim>(problem, cells, around, i);
        sigma[i] = paper ? paperUpdate<Dim>(material, old.sigma[i], gradient[i], dt)
                         : rotatedMidpoint<Dim>(material, old.sigma[i], gradient[i]);
    }
    return sigma;
}

template <int Dim>
std::vector<Tensor<Dim>> solidElementStress(const Problem<Dim>& problem, const SolidControls& controls,
                                            const Cells<Dim>& cells, const Patches<Dim>& end,
                                            const Nodes<Dim>& trial) {
    const auto symmetric = [](const Tensor<Dim>& L) { return Tensor<Dim>(0.5 * (L + L.transpose())); };
    const auto L = elementGradient<Dim>(end, trial.v);
    const auto mean = elementMean<Dim>(end, nodalMean<Dim>(end, L));
    std::vector<Tensor<Dim>> stress(L.size(), Tensor<Dim>::Zero());
    for (int e = 0; e < end.nCells(); ++e) {
        const Hypoelastic& material = problem.solid(cells.material[e]);
        double size = 0;
        for (int node : end.cell(e)) {
            stress[e] += stressTensor<Dim>(trial.sigma[node]) / (Dim + 1);
            size += trial.h[node] / (Dim + 1);
        }
        stress[e] += dampingTime(material, controls.damping, size) *
                     stressTensor<Dim>(elasticStress<Dim>(material, symmetric(L[e] - mean[e])));
    }
    return stress;
}

template const Hypoelastic& solidMaterial<2>(const Problem<2>&, const Cells<2>&, const NodeToCells&, int);
template std::vector<Stress<2>> solidStress<2>(const Problem<2>&, const SolidControls&, const Cells<2>&,
                                               const Patches<2>&, const Patches<2>&, const Nodes<2>&,
                                               const Nodes<2>&, double);
template std::vector<Tensor<2>> solidElementStress<2>(const Problem<2>&, const SolidControls&, const Cells<2>&,
                                                      const Patches<2>&, const Nodes<2>&);

}  // namespace pfem
