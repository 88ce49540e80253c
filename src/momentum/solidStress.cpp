#include "momentum/solidStress.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "integration/materialRuns.hpp"
#include "material/hypoelastic.hpp"
#include "material/neoHookean.hpp"
#include "momentum/solidHistory.hpp"

namespace pfem {

namespace {

/// The kinds of laws that the cells have, each once, and that of each cell.
template <int Dim>
class KindsOfLaws {
public:
    KindsOfLaws(const Problem<Dim>& problem, const Cells<Dim>& cells) : cells_(cells) {
        for (const auto& material : problem.materials) {
            const bool solid = material.kind == MaterialKind::solid;
            ofMaterial_.push_back(solid ? material.solid.law->kinematics() : Kinematics::midpoint);
        }
        for (const Kinematics kind : {Kinematics::midpoint, Kinematics::endPoint, Kinematics::reference})
            if (std::any_of(cells.material.begin(), cells.material.end(),
                            [&](int m) { return ofMaterial_[m] == kind; }))
                kinds.push_back(kind);
    }

    std::vector<Kinematics> kinds;

    bool has(Kinematics kind) const { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }
    bool only(Kinematics kind) const { return kinds.size() == 1 && kinds[0] == kind; }
    Kinematics ofCell(int e) const { return ofMaterial_[cells_.material[e]]; }
    bool isTotal(int e) const { return ofCell(e) == Kinematics::reference; }

    /// `whole` where all cells are of one kind; otherwise put together from a field of each kind: make(kind).
    template <class Make>
    auto perCell(const Make& make) const {
        auto field = make(kinds[0]);
        for (std::size_t k = 1; k < kinds.size(); ++k) {
            const auto other = make(kinds[k]);
            for (int e = 0; e < cells_.size(); ++e)
                if (ofCell(e) == kinds[k]) field[e] = other[e];
        }
        return field;
    }

private:
    const Cells<Dim>& cells_;
    std::vector<Kinematics> ofMaterial_;
};

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

/// Element stress with the force of the energy sum_p Omega_p W(F_p), F_p over the reference domains: the mean of the
/// points' first Piola stress, carried to the current element by its own F_e. For elements: sigma itself.
template <int Dim>
PerCell<Tensor<Dim>> hyperelasticElementStress(const SmoothingDomains<Dim>& reference,
                                               const PerPoint<Stress<Dim>>& sigma, const Points<Dim>& x) {
    const auto F = elementGradient<Dim>(reference, x);
    const auto pointF = toPoints<Dim>(reference, F);
    PerPoint<Tensor<Dim>> P(sigma.size(), Tensor<Dim>::Zero());
    for (int p = 0; p < nStressPoints<Dim>(reference); ++p)
        if (isStressPoint<Dim>(reference, p)) P[p] = firstPiola<Dim>(sigma[p], pointF[p]);
    auto stress = fromPoints<Dim>(reference, std::move(P));
    for (int e = 0; e < reference.nCells(); ++e) stress[e] *= F[e].transpose() / F[e].determinant();
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
const Solid& solidMaterial(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                           int point) {
    return problem.solid(cells.material[cellOfPoint<Dim>(domains, point)]);
}

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

namespace {

/// A trial motion at the stress points.
template <int Dim>
struct PointMotion {
    const Problem<Dim>& problem;
    const Cells<Dim>& cells;
    const SmoothingDomains<Dim>& domains;
    PerPoint<Tensor<Dim>> gradient;  // as the laws take it
    double dt;
};

template <int Dim>
PointMotion<Dim> pointMotion(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                             const Nodes<Dim>& old, const Nodes<Dim>& trial, double dt) {
    const KindsOfLaws<Dim> laws(problem, cells);
    const auto gradient = [&](Kinematics kind) {
        return elementGradient<Dim>(domains, gradientField<Dim>(kind, old, trial, dt));
    };
    return {problem, cells, domains, toPoints<Dim>(domains, laws.perCell(gradient)), dt};
}

/// The stress at the stress points by their laws, and what the laws then remember: in `history`, from that at the start
/// of the step to that at its end.
template <int Dim>
void updateStress(const PointMotion<Dim>& motion, PerPoint<Stress<Dim>>& sigma, History& history) {
    forMaterialRuns<Dim>(motion.domains, motion.cells, [&](int material, int first, int last) {
        const SolidLaw& law = *motion.problem.solid(material).law;
        SolidPoints<Dim> points{runOf(motion.gradient, first, last), runOf(sigma, first, last), {}, {}, motion.dt};
        const auto columns = history.empty() ? std::vector<int>{} : historyColumns(law, history.names);
        std::vector<double> before, after;
        if (!columns.empty()) {
            for (int p = first; p < last; ++p)
                for (const int k : columns) before.push_back(history.at(p, k));
            after = before;
            points.before = before;
            points.history = after;
        }
        law.stress(points);
        std::size_t next = 0;
        for (int p = first; p < last && !columns.empty(); ++p)
            for (const int k : columns) history.at(p, k) = after[next++];
    });
}

/// velocityPressure, laws in rates: the stress at the nodes by the elasticity of the laws.
template <int Dim>
void predictStress(const PointMotion<Dim>& motion, PerPoint<Stress<Dim>>& sigma) {
    forMaterialRuns<Dim>(motion.domains, motion.cells, [&](int material, int first, int last) {
        const SolidLaw& law = *motion.problem.solid(material).law;
        if (law.kinematics() == Kinematics::reference) return;
        law.predict(
            SolidPoints<Dim>{runOf(motion.gradient, first, last), runOf(sigma, first, last), {}, {}, motion.dt});
    });
}

/// velocityPressure: p of the nodes.
template <int Dim>
PerNode<double> nodalPressure(const Problem<Dim>& problem, const Cells<Dim>& cells,
                              const SmoothingDomains<Dim>& domains, const Nodes<Dim>& old, const Nodes<Dim>& trial,
                              double dt) {
    PerNode<double> p(domains.nNodes(), 0.0);
    if (domains.nCells() == 0) return p;
    const KindsOfLaws<Dim> laws(problem, cells);
    const auto nodes = withNodalPoints<Dim>(domains);
    PerNode<double> J;
    PerPoint<Stress<Dim>> sigma;
    if (laws.has(Kinematics::reference)) J = volumeRatio<Dim>(domains, trial.x);
    if (!laws.only(Kinematics::reference)) {
        sigma = PerPoint<Stress<Dim>>(old.sigma);
        predictStress<Dim>(pointMotion<Dim>(problem, cells, nodes, old, trial, dt), sigma);
    }
    for (int i = 0; i < nodes.nNodes(); ++i)
        if (isStressPoint<Dim>(nodes, i))
            p[i] = laws.isTotal(cellOfPoint<Dim>(nodes, i))
                       ? solidMaterial<Dim>(problem, cells, nodes, i).law->volumePressure(J[i])
                       : pressure<Dim>(sigma[i]);
    return p;
}

}  // namespace

template <int Dim>
PerNode<double> volumeRatio(const SmoothingDomains<Dim>& reference, const Points<Dim>& x) {
    const NodeToCells& around = *reference.around;
    PerNode<double> J(reference.nNodes(), 1.0);
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
SolidStress<Dim> solidStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains, const Nodes<Dim>& old,
                             const Nodes<Dim>& trial, double dt) {
    const auto& [problem, controls, cells] = solids;
    SolidStress<Dim> stress;
    stress.point = storedAtPoints<Dim>(domains, old.sigma, cells.sigma);
    if (domains.nCells() > 0) {
        stress.history = historyAtPoints<Dim>(problem, cells, domains, old.history);
        const auto motion = pointMotion<Dim>(problem, cells, domains, old, trial, dt);
        updateStress<Dim>(motion, stress.point, stress.history);
        const bool whole = !controls.withPressure();
        forMaterialRuns<Dim>(domains, cells, [&](int material, int first, int last) {
            const SolidLaw& law = *problem.solid(material).law;
            const bool total = law.kinematics() == Kinematics::reference;
            for (int p = first; p < last; ++p)
                if (total && whole)
                    stress.point[p] =
                        withPressure<Dim>(stress.point[p], law.volumePressure(motion.gradient[p].determinant()));
                else if (!total && !whole)
                    stress.point[p] = deviator<Dim>(stress.point[p]);
        });
    }
    if (controls.withPressure()) stress.pressure = nodalPressure<Dim>(problem, cells, domains, old, trial, dt);
    return stress;
}

template <int Dim>
PerCell<Tensor<Dim>> solidElementStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains,
                                        const SmoothingDomains<Dim>& end, const SolidStress<Dim>& stress,
                                        const Nodes<Dim>& trial) {
    const auto& [problem, controls, cells] = solids;
    if (end.nCells() == 0) return {};
    auto sum = KindsOfLaws<Dim>(problem, cells).perCell([&](Kinematics kind) {
        return kind == Kinematics::reference ? hyperelasticElementStress<Dim>(domains, stress.point, trial.x)
                                             : cauchyElementStress<Dim>(end, stress.point);
    });
    const auto L = elementGradient<Dim>(end, trial.v);
    const auto mean = fromPoints<Dim>(end, toPoints<Dim>(end, L));
    for (int e = 0; e < end.nCells(); ++e) {
        const Solid& material = problem.solid(cells.material[e]);
        const Tensor<Dim> zigzag = L[e] - mean[e];
        sum[e] += dampingTime(material, controls.damping, cellMean<Dim>(end, trial.h, e)) *
                  stressTensor<Dim>(elasticStress<Dim>(material.elastic, 0.5 * (zigzag + zigzag.transpose())));
        if (!stress.pressure.empty()) sum[e] -= cellMean<Dim>(end, stress.pressure, e) * Tensor<Dim>::Identity();
    }
    return sum;
}

template <int Dim>
PerCell<Tensor<Dim>> storedElementStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains,
                                         const Nodes<Dim>& nodes) {
    const auto& [problem, controls, cells] = solids;
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
    storeFromPoints<Dim>(domains, std::move(stress.point), nodal, cell);
    if (stress.pressure.empty()) return;
    for (std::size_t i = 0; i < nodal.size(); ++i) nodal[i] = withPressure<Dim>(nodal[i], stress.pressure[i]);
    for (std::size_t e = 0; e < cell.size(); ++e)
        cell[e] = withPressure<Dim>(cell[e], cellMean<Dim>(domains, stress.pressure, static_cast<int>(e)));
}

#define PFEM_INSTANTIATE(D)                                                                                            \
    template const Solid& solidMaterial<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&, int);       \
    template PerNode<double> volumeRatio<D>(const SmoothingDomains<D>&, const Points<D>&);                             \
    template void updateGradientDomains<D>(const Problem<D>&, const Cells<D>&, const Nodes<D>&, const Nodes<D>&,       \
                                           SmoothingDomains<D>&);                                                      \
    template SolidStress<D> solidStress<D>(const Solids<D>&, const SmoothingDomains<D>&, const Nodes<D>&,              \
                                           const Nodes<D>&, double);                                                   \
    template PerCell<Tensor<D>> solidElementStress<D>(const Solids<D>&, const SmoothingDomains<D>&,                    \
                                                      const SmoothingDomains<D>&, const SolidStress<D>&,               \
                                                      const Nodes<D>&);                                                \
    template PerCell<Tensor<D>> storedElementStress<D>(const Solids<D>&, const SmoothingDomains<D>&, const Nodes<D>&); \
    template void storeSolidStress<D>(const SmoothingDomains<D>&, SolidStress<D>, PerNode<Stress<D>>&,                 \
                                      std::vector<Stress<D>>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
