#include "continuity/residual.hpp"

#include "base/parallel.hpp"
#include "continuity/stabilisation.hpp"

namespace pfem {

namespace {

/// Per cell: the volume rate that each of its nodes receives, and the stabilisation's flux
/// |e| (tau (grad p - rho g) + (tau - tau_0) rho a).
template <int Dim>
struct CellTerms {
    std::vector<double> rate;
    std::vector<double> compressibility;  // |e|/(d+1) / kappa
    std::vector<Vec<Dim>> flux;
};

template <int Dim>
CellTerms<Dim> cellTerms(const Problem<Dim>& problem, const Cells<Dim>& cells, const Patches<Dim>& patches,
                         const std::vector<double>& tau, double tauFaces, const Nodes<Dim>& trial,
                         const Nodes<Dim>& middle, const std::vector<unsigned char>& projected, double divTarget) {
    CellTerms<Dim> t;
    t.rate.resize(cells.nodes.size());
    t.compressibility.resize(cells.nodes.size());
    t.flux.resize(cells.nodes.size());
#pragma omp parallel for schedule(static) if (cells.size() > shortLoop)
    for (int e = 0; e < cells.size(); ++e) {
        const auto& g = patches.element[e];
        double growth = 0;  // |e| div v at the end of the step
        Vec<Dim> gradP = Vec<Dim>::Zero();
        Vec<Dim> a = Vec<Dim>::Zero();
        for (int k = 0; k <= Dim; ++k) {
            const int node = cells.nodes[e][k];
            growth -= trial.v[node].dot(faceArea<Dim>(trial.x, oppositeFace<Dim>(cells.nodes[e], k))) / Dim;
            gradP += middle.p[node] * g.gradN[k];
            if (!projected[e]) a += middle.a[node] / (Dim + 1);
        }
        const ViscousFluid& fluid = problem.fluid(cells.material[e]);
        const double share = g.measure / (Dim + 1);
        t.rate[e] = growth / (Dim + 1) - share * divTarget;
        t.compressibility[e] = share / fluid.kappa;
        t.flux[e] = g.measure * (tau[e] * (gradP - fluid.rho * problem.gravity) + (tau[e] - tauFaces) * fluid.rho * a);
    }
    return t;
}

/// flux_e -= |e| tau_e times the mean over the cell's nodes of the tau-weighted mean of flux/(|e| tau) around each
/// node.
template <int Dim>
void subtractProjection(const Patches<Dim>& patches, const NodeToCells& around, const std::vector<double>& tau,
                        const std::vector<unsigned char>& projected, std::vector<Vec<Dim>>& flux) {
    Points<Dim> mean(patches.nNodes(), Vec<Dim>::Zero());
    forEach(patches.nNodes(), [&](int i) {
        double weight = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const int e = around.cell[s];
            if (!projected[e]) continue;
            weight += tau[e] * patches.element[e].measure;
            mean[i] += flux[e];
        }
        if (weight > 0) mean[i] /= weight;
    });
    forEach(patches.nCells(), [&](int e) {
        if (!projected[e]) return;
        Vec<Dim> m = Vec<Dim>::Zero();
        for (int node : patches.cell(e)) m += mean[node] / (Dim + 1);
        flux[e] -= tau[e] * patches.element[e].measure * m;
    });
}

template <int Dim>
double meanOverCells(const Patches<Dim>& patches, const std::vector<double>& value) {
    double sum = 0, volume = 0;
    for (int e = 0; e < patches.nCells(); ++e) {
        sum += patches.element[e].measure * value[e];
        volume += patches.element[e].measure;
    }
    return volume > 0 ? sum / volume : 0;
}

}  // namespace

double volumeReturnRate(const ContinuityControls& controls, double dt) {
    constexpr double leastSteps = 4;  // 2.5 already lets waves grow (doc/decisions.md)
    return controls.volumeReturnTime > 0 ? 1 / std::max(controls.volumeReturnTime, leastSteps * dt) : 0;
}

template <int Dim>
std::vector<double> continuityResidual(const Problem<Dim>& problem, const ContinuityControls& controls,
                                       const Cells<Dim>& cells, const Topology<Dim>& topology,
                                       const Patches<Dim>& patches, const std::vector<double>& mu,
                                       const Stabilisation& stabilisation, const Nodes<Dim>& trial,
                                       const Nodes<Dim>& middle, const Nodes<Dim>& old, double dt, double divTarget) {
    const bool inertia = controls.stabilisation != "bodyForce";
    const bool projection = controls.stabilisation == "projection";
    const auto& [tau, projected] = stabilisation;
    const double tauFaces = inertia ? 0 : meanOverCells<Dim>(patches, tau);
    auto terms = cellTerms<Dim>(problem, cells, patches, tau, tauFaces, trial, middle, projected, divTarget);
    const NodeToCells& around = topology.fluid;
    if (projection) subtractProjection<Dim>(patches, around, tau, projected, terms.flux);
    const double returnRate = volumeReturnRate(controls, dt);
    std::vector<double> R(trial.size(), 0.0);
#pragma omp parallel for schedule(static) if (cells.size() > shortLoop)
    for (int i = 0; i < topology.nNodes(); ++i) {
        double compressibility = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const int e = around.cell[s];
            compressibility += terms.compressibility[e];
            R[i] += terms.rate[e] + terms.flux[e].dot(patches.element[e].gradN[around.corner[s]]);
        }
        R[i] += compressibility * (middle.p[i] - old.p[i]) / dt;
        if (around.count(i) > 0) R[i] -= returnRate * old.lostVolume[i];
    }

    for (const auto& face : topology.faces) {
        const bool free = face.kind == FaceKind::freeSurface;
        if (!free && (inertia || !controls.interfaceAcceleration)) continue;
        const ViscousFluid& fluid = problem.fluid(cells.material[face.cell]);
        const auto& g = patches.element[face.cell];
        const Vec<Dim> area = faceArea<Dim>(middle.x, face.nodes);
        const double measure = area.norm();
        if (measure == 0) continue;
        const Vec<Dim> n = area / measure;
        if (!inertia)
            for (int node : face.nodes) R[node] += tauFaces * measure / Dim * fluid.rho * middle.a[node].dot(n);
        if (!free || projected[face.cell]) continue;

        const double twoOverH = 2 * measure / (Dim * g.measure);
        Vec<Dim> dn = Vec<Dim>::Zero();  // L n of the cell
        for (int k = 0; k <= Dim; ++k) dn += middle.v[cells.nodes[face.cell][k]] * g.gradN[k].dot(n);
        const double viscous = 2 * mu[face.cell] * dn.dot(n);
        const double weight =
            surfaceStabilisation<Dim>(tau[face.cell], mu[face.cell], g.measure, measure) * measure / Dim;
        for (int node : face.nodes) R[node] += weight * twoOverH * (middle.p[node] - viscous);
    }
    return R;
}

template std::vector<double> continuityResidual<2>(const Problem<2>&, const ContinuityControls&, const Cells<2>&,
                                                   const Topology<2>&, const Patches<2>&, const std::vector<double>&,
                                                   const Stabilisation&, const Nodes<2>&, const Nodes<2>&,
                                                   const Nodes<2>&, double, double);

}  // namespace pfem
