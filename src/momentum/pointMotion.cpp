#include "momentum/pointMotion.hpp"

#include "base/parallel.hpp"
#include "momentum/kindsOfLaws.hpp"

namespace pfem {

namespace {

/// The positions whose gradients a kind of law takes.
template <int Dim>
Points<Dim> gradientPositions(Kinematics kind, const Nodes<Dim>& old, const Nodes<Dim>& trial) {
    if (kind == Kinematics::endPoint) return trial.x;
    if (kind == Kinematics::reference) return trial.X;
    Points<Dim> middle(old.x.size());
    parallelFor(old.size(), [&](int i) { middle[i] = 0.5 * (old.x[i] + trial.x[i]); });
    return middle;
}

/// The nodal field whose gradient a kind of law takes.
template <int Dim>
Points<Dim> gradientField(Kinematics kind, const Nodes<Dim>& old, const Nodes<Dim>& trial, double dt) {
    if (kind == Kinematics::endPoint) return trial.v;
    if (kind == Kinematics::reference) return trial.x;
    Points<Dim> increment(old.x.size());
    parallelFor(old.size(), [&](int i) {  // x - x^n without its cancellation
        increment[i] = 0.5 * dt * (old.v[i] + trial.v[i]);
    });
    return increment;
}

}  // namespace

template <int Dim>
void updateGradientDomains(const Problem<Dim>& problem, const Cells<Dim>& cells, const Nodes<Dim>& old,
                           const Nodes<Dim>& trial, SmoothingDomains<Dim>& domains) {
    const KindsOfLaws<Dim> laws(problem, cells);
    if (laws.kinds.empty()) return;
    const auto positions = [&](Kinematics kind) { return gradientPositions<Dim>(kind, old, trial); };
    updateSmoothingDomains<Dim>(domains, positions(laws.kinds[0]));
    if (laws.kinds.size() == 1) return;
    domains.element = laws.perCell([&](Kinematics kind) {
        SmoothingDomains<Dim> at = domains;
        updateSmoothingDomains<Dim>(at, positions(kind));
        return at.element;
    });
    updateVolumes<Dim>(domains);
}

template <int Dim>
PointMotion<Dim> pointMotion(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                             const Nodes<Dim>& old, const Nodes<Dim>& trial, double dt) {
    const KindsOfLaws<Dim> laws(problem, cells);
    const auto gradient = [&](Kinematics kind) {
        return elementGradient<Dim>(domains, gradientField<Dim>(kind, old, trial, dt));
    };
    return {problem, cells, domains, toPoints<Dim>(domains, laws.perCell(gradient)), dt};
}

#define PFEM_INSTANTIATE(D)                                                                                      \
    template void updateGradientDomains<D>(const Problem<D>&, const Cells<D>&, const Nodes<D>&, const Nodes<D>&, \
                                           SmoothingDomains<D>&);                                                \
    template PointMotion<D> pointMotion<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&,       \
                                           const Nodes<D>&, const Nodes<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
