#include "momentum/solidElementStress.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "integration/materialRuns.hpp"
#include "material/hypoelastic.hpp"
#include "material/neoHookean.hpp"
#include "momentum/kindsOfLaws.hpp"
#include "momentum/pointMotion.hpp"

namespace pfem {

namespace {

/// Element stress with the force of the energy sum_p Omega_p W(F_p), F_p over the reference domains: the mean of the
/// points' first Piola stress, carried to the current element by its own F_e. For elements: sigma itself.
template <int Dim>
PerCell<Tensor<Dim>> hyperelasticElementStress(const SmoothingDomains<Dim>& reference,
                                               const PerPoint<Stress<Dim>>& sigma, const Points<Dim>& x) {
    const auto F = elementGradient<Dim>(reference, x);
    const auto pointF = toPoints<Dim>(reference, F);
    PerPoint<Tensor<Dim>> P(sigma.size(), Tensor<Dim>::Zero());
    parallelFor(nStressPoints<Dim>(reference), [&](int p) {
        if (isStressPoint<Dim>(reference, p)) P[p] = firstPiola<Dim>(sigma[p], pointF[p]);
    });
    auto stress = fromPoints<Dim>(reference, std::move(P));
    parallelFor(reference.nCells(), [&](int e) { stress[e] *= F[e].transpose() / F[e].determinant(); });
    return stress;
}

template <int Dim>
PerCell<Tensor<Dim>> cauchyElementStress(const SmoothingDomains<Dim>& domains, const PerPoint<Stress<Dim>>& sigma) {
    PerPoint<Tensor<Dim>> point(sigma.size());
    parallelFor(static_cast<int>(sigma.size()), [&](int p) { point[p] = stressTensor<Dim>(sigma[p]); });
    return fromPoints<Dim>(domains, std::move(point));
}

}  // namespace

double dampingTime(const Solid& material, double alpha, double h) {
    return alpha * h * std::sqrt(material.rho / material.elastic.E);
}

template <int Dim>
PerCell<Tensor<Dim>> solidElementStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains,
                                        const SmoothingDomains<Dim>& end, const SolidStress<Dim>& stress,
                                        const Nodes<Dim>& trial) {
    const Problem<Dim>& problem = solids.problem;
    const SolidControls& controls = solids.controls;
    const Cells<Dim>& cells = solids.cells;
    if (end.nCells() == 0) return {};
    auto sum = KindsOfLaws<Dim>(problem, cells).perCell([&](Kinematics kind) {
        return kind == Kinematics::reference ? hyperelasticElementStress<Dim>(domains, stress.point, trial.x)
                                             : cauchyElementStress<Dim>(end, stress.point);
    });
    const auto L = elementGradient<Dim>(end, trial.v);
    const auto mean = fromPoints<Dim>(end, toPoints<Dim>(end, L));
    parallelFor(end.nCells(), [&](int e) {
        const Solid& material = problem.solid(cells.material[e]);
        const Tensor<Dim> zigzag = L[e] - mean[e];
        sum[e] += dampingTime(material, controls.damping, cellMean<Dim>(end, trial.h, e)) *
                  stressTensor<Dim>(elasticStress<Dim>(material.elastic, 0.5 * (zigzag + zigzag.transpose())));
        if (!stress.pressure.empty()) sum[e] -= cellMean<Dim>(end, stress.pressure, e) * Tensor<Dim>::Identity();
    });
    return sum;
}

template <int Dim>
PerCell<Tensor<Dim>> storedElementStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains,
                                         const Nodes<Dim>& nodes) {
    const Problem<Dim>& problem = solids.problem;
    const Cells<Dim>& cells = solids.cells;
    if (domains.nCells() == 0) return {};
    auto gradients = domains;
    updateGradientDomains<Dim>(problem, cells, nodes, nodes, gradients);
    // a hyperelastic stress follows from the positions; the others are what is stored
    SolidStress<Dim> stress{storedAtPoints<Dim>(domains, nodes.sigma, cells.sigma), {}, {}};
    const KindsOfLaws<Dim> laws(problem, cells);
    if (laws.has(Kinematics::reference)) {
        auto ofPositions = solidStress<Dim>(solids, gradients, nodes, nodes, 0);
        forMaterialRuns<Dim>(domains, cells, [&](int material, int first, int last) {
            if (problem.solid(material).law->kinematics() == Kinematics::reference)
                std::copy(ofPositions.point.begin() + first, ofPositions.point.begin() + last,
                          stress.point.begin() + first);
        });
        stress.pressure = std::move(ofPositions.pressure);
        for (int i = 0; i < static_cast<int>(stress.pressure.size()); ++i)
            if (domains.around->count(i) > 0 && !laws.isTotal(domains.around->cell[domains.around->start[i]]))
                stress.pressure[i] = 0;
    }
    return solidElementStress<Dim>(solids, gradients, domains, stress, nodes);
}

template <int Dim>
void storeSolidStress(const SmoothingDomains<Dim>& domains, SolidStress<Dim> stress, PerNode<Stress<Dim>>& nodal,
                      std::vector<Stress<Dim>>& cell) {
    if (domains.nCells() == 0) return;
    storeFromPoints<Dim>(domains, std::move(stress.point), nodal, cell);
    if (stress.pressure.empty()) return;
    for (std::size_t i = 0; i < nodal.size(); ++i) nodal[i] = withPressure<Dim>(nodal[i], stress.pressure[i]);
    for (std::size_t e = 0; e < cell.size(); ++e)
        cell[e] = withPressure<Dim>(cell[e], cellMean<Dim>(domains, stress.pressure, static_cast<int>(e)));
}

#define PFEM_INSTANTIATE(D)                                                                                            \
    template PerCell<Tensor<D>> solidElementStress<D>(const Solids<D>&, const SmoothingDomains<D>&,                    \
                                                      const SmoothingDomains<D>&, const SolidStress<D>&,               \
                                                      const Nodes<D>&);                                                \
    template PerCell<Tensor<D>> storedElementStress<D>(const Solids<D>&, const SmoothingDomains<D>&, const Nodes<D>&); \
    template void storeSolidStress<D>(const SmoothingDomains<D>&, SolidStress<D>, PerNode<Stress<D>>&,                 \
                                      std::vector<Stress<D>>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
