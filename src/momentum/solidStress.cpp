#include "momentum/solidStress.hpp"

#include "integration/materialRuns.hpp"
#include "material/neoHookean.hpp"
#include "momentum/kindsOfLaws.hpp"
#include "momentum/pointMotion.hpp"
#include "momentum/solidHistory.hpp"

namespace pfem {

template <int Dim>
const Solid& solidMaterial(const Problem<Dim>& problem, const Cells<Dim>& cells, const SmoothingDomains<Dim>& domains,
                           int point) {
    return problem.solid(cells.material[cellOfPoint<Dim>(domains, point)]);
}

namespace {

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
    parallelFor(reference.nNodes(), [&](int i) {
        if (around.count(i) == 0) return;
        double volume = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            volume += simplexMeasure<Dim>(x, reference.cell(around.cell[s]));
        J[i] = volume / ((Dim + 1) * reference.volume[i]);
    });
    return J;
}

template <int Dim>
SolidStress<Dim> solidStress(const Solids<Dim>& solids, const SmoothingDomains<Dim>& domains, const Nodes<Dim>& old,
                             const Nodes<Dim>& trial, double dt) {
    const Problem<Dim>& problem = solids.problem;
    const SolidControls& controls = solids.controls;
    const Cells<Dim>& cells = solids.cells;
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

#define PFEM_INSTANTIATE(D)                                                                                      \
    template const Solid& solidMaterial<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&, int); \
    template PerNode<double> volumeRatio<D>(const SmoothingDomains<D>&, const Points<D>&);                       \
    template SolidStress<D> solidStress<D>(const Solids<D>&, const SmoothingDomains<D>&, const Nodes<D>&,        \
                                           const Nodes<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
