#include "integration/smoothingDomains.hpp"

namespace pfem {

template <int Dim>
SmoothingDomains<Dim> makeSmoothingDomains(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around,
                                           const Points<Dim>& x, Integration scheme, const Share& share) {
    SmoothingDomains<Dim> domains;
    domains.share = share;
    domains.scheme = scheme;
    domains.cells = &cells;
    domains.around = &around;
    domains.element.resize(cells.size());
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
    const NodeToCells& around = *domains.around;
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        double sum = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) sum += domains.element[around.cell[s]].measure;
        domains.volume[i] = sum / (Dim + 1);
    });
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
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        Value sum = Value::Zero();
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            sum += domains.element[around.cell[s]].measure * field[around.cell[s]];
        if (around.count(i) > 0) sum /= (Dim + 1) * domains.volume[i];
        mean[i] = sum;
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
    const NodeToCells& around = *domains.around;
    if (domains.nCells() == 0) return;
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        Vec<Dim> sum = force[i];
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const auto& g = domains.element[around.cell[s]];
            sum += g.measure * (stress[around.cell[s]] * g.gradN[around.corner[s]]);
        }
        force[i] = sum;
    });
}

template <int Dim>
void addPressureForce(const SmoothingDomains<Dim>& domains, const PerNode<double>& p, Points<Dim>& force) {
    const NodeToCells& around = *domains.around;
    if (domains.nCells() == 0) return;
    PerCell<double> whole(domains.nCells());  // |e| times the mean pressure
    domains.share.forCells(domains.nCells(), [&](int e) {
        double sum = 0;
        for (int node : domains.cell(e)) sum += p[node];
        whole[e] = domains.element[e].measure * sum / (Dim + 1);
    });
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        Vec<Dim> sum = force[i];
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            sum -= whole[around.cell[s]] * domains.element[around.cell[s]].gradN[around.corner[s]];
        force[i] = sum;
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
