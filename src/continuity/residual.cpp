#include "continuity/residual.hpp"

#include <utility>

#include "base/chosen.hpp"
#include "continuity/stabilisation.hpp"
#include "integration/sumAtNodes.hpp"
#include "momentum/bentWalls.hpp"
#include "momentum/meniscus.hpp"

namespace pfem {

namespace {

/// Per cell: the volume rate that each of its nodes receives, and the stabilisation's flux
/// |e| (tau (grad p - rho g) + (tau - tau_0) rho a).
template <int Dim>
struct CellTerms {
    PerCell<double> rate;
    PerCell<double> compressibility;  // |e|/(d+1) / kappa
    PerCell<Vec<Dim>> flux;
};

template <int Dim>
CellTerms<Dim> cellTerms(const Step<Dim>& step, const FluidPhase<Dim>& phase, const Stabilisation& stabilisation,
                         double tauFaces, const Trial<Dim>& trial) {
    const auto& tau = stabilisation.tau;
    const auto& projected = stabilisation.projected;
    const Cells<Dim>& cells = phase.cells;
    const Vec<Dim> gravity = step.problem.gravity + trial.drive;
    CellTerms<Dim> t;
    t.rate.resize(cells.nodes.size());
    t.compressibility.resize(cells.nodes.size());
    t.flux.resize(cells.nodes.size());
    phase.domains.share.forCells(cells.size(), [&](int e) {
        const auto& g = phase.domains.element[e];
        double growth = 0;  // |e| div v at the end of the step
        Vec<Dim> gradP = Vec<Dim>::Zero();
        Vec<Dim> a = Vec<Dim>::Zero();
        for (int k = 0; k <= Dim; ++k) {
            const int node = cells.nodes[e][k];
            growth -= trial.end.v[node].dot(faceArea<Dim>(trial.end.x, oppositeFace<Dim>(cells.nodes[e], k))) / Dim;
            gradP += trial.middle.p[node] * g.gradN[k];
            if (!projected[e]) a += trial.middle.a[node] / (Dim + 1);
        }
        const ViscousFluid& fluid = step.problem.fluid(cells.material[e]);
        const double share = g.measure / (Dim + 1);
        t.rate[e] = growth / (Dim + 1) - share * step.divTarget;
        t.compressibility[e] = share / fluid.kappa;
        t.flux[e] = g.measure * (tau[e] * (gradP - fluid.rho * gravity) + (tau[e] - tauFaces) * fluid.rho * a);
    });
    return t;
}

/// flux_e -= |e| tau_e times the mean over the cell's nodes of the tau-weighted mean of flux/(|e| tau) around each
/// node.
template <int Dim>
void subtractProjection(const SmoothingDomains<Dim>& domains, const PerCell<double>& tau,
                        const PerCell<unsigned char>& projected, PerCell<Vec<Dim>>& flux) {
    Points<Dim> mean(domains.nNodes(), Vec<Dim>::Zero());  // its share in a cell's mean
    std::vector<double> weight(domains.nNodes(), 0.0);
    sumAtNodes(domains, [&](int e) {
        return [&, isProjected = projected[e] != 0, w = tau[e] * domains.element[e].measure,
                &f = std::as_const(flux[e])](int, int node) {
            if (!isProjected) return;
            weight[node] += w;
            mean[node] += f;
        };
    });
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        if (weight[i] > 0)
            mean[i] = mean[i] / weight[i] / (Dim + 1);
        else
            mean[i].setZero();
    });
    domains.share.forCells(domains.nCells(), [&](int e) {
        if (!projected[e]) return;
        Vec<Dim> m = Vec<Dim>::Zero();
        for (int node : domains.cell(e)) m += mean[node];
        flux[e] -= tau[e] * domains.element[e].measure * m;
    });
}

/// What a face gives to its nodes: its own acceleration, and the weak p = 0.
template <int Dim>
struct FaceTerms {
    std::array<double, Dim> inertia{}, pressure{};
};

template <int Dim>
FaceTerms<Dim> faceTerms(const Step<Dim>& step, const FluidPhase<Dim>& phase, const Stabilisation& stabilisation,
                         double tauFaces, const Nodes<Dim>& middle, const FluidFace<Dim>& face) {
    FaceTerms<Dim> t;
    const auto& tau = stabilisation.tau;
    const Cells<Dim>& cells = phase.cells;
    const ViscousFluid& fluid = step.problem.fluid(cells.material[face.cell]);
    const auto& g = phase.domains.element[face.cell];
    const Vec<Dim> area = faceArea<Dim>(middle.x, face.nodes);
    const double measure = area.norm();
    if (measure == 0) return t;
    const Vec<Dim> n = area / measure;
    for (int k = 0; tauFaces != 0 && k < Dim; ++k)
        t.inertia[k] = tauFaces * measure / Dim * fluid.rho * middle.a[face.nodes[k]].dot(n);
    if (face.kind != FaceKind::freeSurface || stabilisation.projected[face.cell]) return t;

    const double twoOverH = 2 * measure / (Dim * g.measure);
    Vec<Dim> dn = Vec<Dim>::Zero();  // L n of the cell
    for (int k = 0; k <= Dim; ++k) dn += middle.v[cells.nodes[face.cell][k]] * g.gradN[k].dot(n);
    const double viscous = 2 * phase.mu[face.cell] * dn.dot(n);
    const double weight =
        surfaceStabilisation<Dim>(tau[face.cell], phase.mu[face.cell], g.measure, measure) * measure / Dim;
    const auto meniscus = meniscusPressure<Dim>(step.problem, fluid.rho, step.topology, middle, face.nodes);
    for (int k = 0; k < Dim; ++k) t.pressure[k] = weight * twoOverH * (middle.p[face.nodes[k]] - meniscus[k] - viscous);
    return t;
}

template <int Dim>
double meanOverCells(const SmoothingDomains<Dim>& domains, const PerCell<double>& value) {
    double sum = 0, volume = 0;
    for (int e = 0; e < domains.nCells(); ++e) {
        sum += domains.element[e].measure * value[e];
        volume += domains.element[e].measure;
    }
    return volume > 0 ? sum / volume : 0;
}

}  // namespace

double volumeReturnRate(const ContinuityControls& controls, double dt) {
    constexpr double leastSteps = 4;  // 2.5 already lets waves grow (doc/decisions.md)
    return controls.volumeReturnTime > 0 ? 1 / std::max(controls.volumeReturnTime, leastSteps * dt) : 0;
}

template <int Dim>
std::vector<double> continuityResidual(const Step<Dim>& step, const ContinuityControls& controls,
                                       const FluidPhase<Dim>& phase, const Stabilisation& stabilisation,
                                       const Trial<Dim>& trial) {
    const bool inertia = controls.stabilisation != "bodyForce";
    const bool projection = controls.stabilisation == "projection";
    const auto& tau = stabilisation.tau;
    const auto& projected = stabilisation.projected;
    const SmoothingDomains<Dim>& domains = phase.domains;
    const Topology<Dim>& topology = step.topology;
    const Nodes<Dim>&middle = trial.middle, &old = step.old;
    const double dt = step.dt();
    const double tauFaces = inertia ? 0 : meanOverCells<Dim>(domains, tau);
    auto terms = cellTerms<Dim>(step, phase, stabilisation, tauFaces, trial);
    const NodeToCells& around = topology.fluid;
    if (projection) subtractProjection<Dim>(domains, tau, projected, terms.flux);
    const double returnRate = volumeReturnRate(controls, dt);
    std::vector<double> R(middle.size(), 0.0), compressibility(middle.size(), 0.0);
    sumAtNodes(domains, [&](int e) {
        return [&R, &compressibility, c = terms.compressibility[e], rate = terms.rate[e], &flux = terms.flux[e],
                &g = domains.element[e]](int k, int node) {
            compressibility[node] += c;
            R[node] += rate + flux.dot(g.gradN[k]);
        };
    });
    domains.share.forNodes(topology.nNodes(), [&](int i) {
        R[i] += compressibility[i] * (middle.p[i] - old.p[i]) / dt;
        if (around.count(i) > 0) R[i] -= returnRate * old.lostVolume[i];
    });

    subtractChordFlux<Dim>(topology, step.constraints, trial.end, R);
    const auto given = parallelChosen(static_cast<int>(topology.faces.size()), [&](int f) {
        return topology.faces[f].kind == FaceKind::freeSurface || (!inertia && controls.interfaceAcceleration);
    });
    std::vector<FaceTerms<Dim>> ofFaces(given.size());
    parallelFor(static_cast<int>(given.size()), [&](int k) {
        ofFaces[k] = faceTerms<Dim>(step, phase, stabilisation, tauFaces, middle, topology.faces[given[k]]);
    });
    for (std::size_t f = 0; f < given.size(); ++f) {
        const Face<Dim>& nodes = topology.faces[given[f]].nodes;
        for (int k = 0; k < Dim; ++k) R[nodes[k]] += ofFaces[f].inertia[k];
        for (int k = 0; k < Dim; ++k) R[nodes[k]] += ofFaces[f].pressure[k];
    }
    return R;
}

#define PFEM_INSTANTIATE(D)                                                                       \
    template std::vector<double> continuityResidual<D>(const Step<D>&, const ContinuityControls&, \
                                                       const FluidPhase<D>&, const Stabilisation&, const Trial<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
