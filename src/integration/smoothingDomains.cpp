#include "integration/smoothingDomains.hpp"

#include <algorithm>

#include "integration/sumAtNodes.hpp"

namespace pfem {

namespace {

/// Of cells that are others'.
template <int Dim>
CellGeometry<Dim> noGeometry() {
    CellGeometry<Dim> none;
    none.measure = 0;
    none.gradN.fill(Vec<Dim>::Zero());
    return none;
}

}  // namespace

template <int Dim>
SmoothingDomains<Dim> makeSmoothingDomains(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around,
                                           const Points<Dim>& x, Integration scheme, const Share& share) {
    SmoothingDomains<Dim> domains;
    domains.share = share;
    domains.scheme = scheme;
    domains.cells = &cells;
    domains.around = &around;
    domains.element.resize(cells.size());
    if (!share.isWhole()) std::fill(domains.element.begin(), domains.element.end(), noGeometry<Dim>());
    domains.volume.resize(x.size());
    updateSmoothingDomains(domains, x);
    return domains;
}

template <int Dim>
void updateSmoothingDomains(SmoothingDomains<Dim>& domains, const Points<Dim>& x) {
    domains.share.forCells(domains.nCells(),
                           [&](int e) { domains.element[e] = simplexGeometry<Dim>(x, domains.cell(e)); });
    updateVolumes(domains);
}

template <int Dim>
void updateVolumes(SmoothingDomains<Dim>& domains) {
    if (domains.nCells() == 0) return;
    PerNode<double>& volume = domains.volume;
    domains.share.forNodes(domains.nNodes(), [&](int i) { volume[i] = 0; });
    sumAtNodes(domains, [&](int e) {
        return [&volume, measure = domains.element[e].measure](int, int node) { volume[node] += measure; };
    });
    domains.share.forNodes(domains.nNodes(), [&](int i) { volume[i] /= Dim + 1; });
}

template <int Dim>
PerCell<Tensor<Dim>> elementGradient(const SmoothingDomains<Dim>& domains, const Points<Dim>& v) {
    PerCell<Tensor<Dim>> L(domains.nCells());
    domains.share.forCells(domains.nCells(),
                           [&](int e) { L[e] = gradientIn<Dim>(domains.element[e], domains.cell(e), v); });
    return L;
}

template <int Dim, class Value>
PerNode<Value> nodalMean(const SmoothingDomains<Dim>& domains, const PerCell<Value>& field) {
    const NodeToCells& around = *domains.around;
    PerNode<Value> mean(domains.nNodes());
    domains.share.forNodes(domains.nNodes(), [&](int i) { mean[i] = Value::Zero(); });
    if (domains.nCells() == 0) return mean;
    sumAtNodes(domains, [&](int e) {
        return [&mean, measure = domains.element[e].measure, &value = field[e]](int, int node) {
            mean[node] += measure * value;
        };
    });
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        if (around.count(i) > 0) mean[i] /= (Dim + 1) * domains.volume[i];
    });
    return mean;
}

template <int Dim, class Value>
PerCell<Value> elementMean(const SmoothingDomains<Dim>& domains, const PerNode<Value>& nodal) {
    PerCell<Value> mean(domains.nCells());
    domains.share.forCells(domains.nCells(), [&](int e) {
        Value sum = nodal[domains.cell(e)[0]];
        for (int k = 1; k <= Dim; ++k) sum += nodal[domains.cell(e)[k]];
        mean[e] = sum / (Dim + 1);
    });
    return mean;
}

template <int Dim>
void addInternalForce(const SmoothingDomains<Dim>& domains, const PerCell<Tensor<Dim>>& stress, Points<Dim>& force) {
    if (domains.nCells() == 0) return;
    sumAtNodes(domains, [&](int e) {
        return [&force, &g = domains.element[e], &sigma = stress[e]](int k, int node) {
            force[node] += g.measure * (sigma * g.gradN[k]);
        };
    });
}

template <int Dim>
void addPressureForce(const SmoothingDomains<Dim>& domains, const PerNode<double>& p, Points<Dim>& force) {
    if (domains.nCells() == 0) return;
    sumAtNodes(domains, [&](int e) {
        double sum = 0;
        for (int node : domains.cell(e)) sum += p[node];
        const double whole = domains.element[e].measure * sum / (Dim + 1);  // |e| times the mean pressure
        return [&force, whole, &g = domains.element[e]](int k, int node) { force[node] -= whole * g.gradN[k]; };
    });
}

#define PFEM_INSTANTIATE(D)                                                                                  \
    template SmoothingDomains<D> makeSmoothingDomains<D>(const std::vector<Simplex<D>>&, const NodeToCells&, \
                                                         const Points<D>&, Integration, const Share&);       \
    template void updateSmoothingDomains<D>(SmoothingDomains<D>&, const Points<D>&);                         \
    template void updateVolumes<D>(SmoothingDomains<D>&);                                                    \
    template PerCell<Tensor<D>> elementGradient<D>(const SmoothingDomains<D>&, const Points<D>&);            \
    template PerNode<Tensor<D>> nodalMean<D>(const SmoothingDomains<D>&, const PerCell<Tensor<D>>&);         \
    template PerNode<Stress<D>> nodalMean<D>(const SmoothingDomains<D>&, const PerCell<Stress<D>>&);         \
    template PerCell<Tensor<D>> elementMean<D>(const SmoothingDomains<D>&, const PerNode<Tensor<D>>&);       \
    template PerCell<Stress<D>> elementMean<D>(const SmoothingDomains<D>&, const PerNode<Stress<D>>&);       \
    template PerCell<double> elementMean<D>(const SmoothingDomains<D>&, const PerNode<double>&);             \
    template void addPressureForce<D>(const SmoothingDomains<D>&, const PerNode<double>&, Points<D>&);       \
    template void addInternalForce<D>(const SmoothingDomains<D>&, const PerCell<Tensor<D>>&, Points<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
