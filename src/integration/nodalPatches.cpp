#include "integration/nodalPatches.hpp"

#include "base/parallel.hpp"

namespace pfem {

template <int Dim>
Patches<Dim> makePatches(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around, const Points<Dim>& x,
                         Integration scheme) {
    Patches<Dim> patches;
    patches.scheme = scheme;
    patches.cells = &cells;
    patches.around = &around;
    patches.element.resize(cells.size());
    patches.volume.resize(x.size());
    updatePatches(patches, x);
    return patches;
}

template <int Dim>
void updatePatches(Patches<Dim>& patches, const Points<Dim>& x) {
    const int nCells = patches.nCells();
    if (nCells == 0) return;
    const int nNodes = patches.nNodes();
    const NodeToCells& around = *patches.around;
#pragma omp parallel if (nCells > shortLoop)
    {
#pragma omp for schedule(static)
        for (int e = 0; e < nCells; ++e) patches.element[e] = simplexGeometry<Dim>(x, patches.cell(e));
#pragma omp for schedule(static)
        for (int i = 0; i < nNodes; ++i) {
            double sum = 0;
            for (int s = around.start[i]; s < around.start[i + 1]; ++s) sum += patches.element[around.cell[s]].measure;
            patches.volume[i] = sum / (Dim + 1);
        }
    }
}

template <int Dim>
void updateVolumes(Patches<Dim>& patches) {
    const NodeToCells& around = *patches.around;
    forEach(patches.nNodes(), [&](int i) {
        double sum = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) sum += patches.element[around.cell[s]].measure;
        patches.volume[i] = sum / (Dim + 1);
    });
}

template <int Dim>
std::vector<Tensor<Dim>> elementGradient(const Patches<Dim>& patches, const Points<Dim>& v) {
    std::vector<Tensor<Dim>> L(patches.nCells());
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int e = 0; e < patches.nCells(); ++e) {
        L[e].setZero();
        for (int k = 0; k <= Dim; ++k) L[e] += v[patches.cell(e)[k]] * patches.element[e].gradN[k].transpose();
    }
    return L;
}

template <int Dim, class Value>
std::vector<Value> nodalMean(const Patches<Dim>& patches, const std::vector<Value>& field) {
    const NodeToCells& around = *patches.around;
    std::vector<Value> mean(patches.nNodes());
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int i = 0; i < patches.nNodes(); ++i) {
        mean[i].setZero();
        if (around.count(i) == 0) continue;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s)
            mean[i] += patches.element[around.cell[s]].measure * field[around.cell[s]];
        mean[i] /= (Dim + 1) * patches.volume[i];
    }
    return mean;
}

template <int Dim, class Value>
std::vector<Value> elementMean(const Patches<Dim>& patches, const std::vector<Value>& nodal) {
    std::vector<Value> mean(patches.nCells());
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int e = 0; e < patches.nCells(); ++e) {
        mean[e] = nodal[patches.cell(e)[0]];
        for (int k = 1; k <= Dim; ++k) mean[e] += nodal[patches.cell(e)[k]];
        mean[e] /= Dim + 1;
    }
    return mean;
}

template <int Dim>
void addInternalForce(const Patches<Dim>& patches, const std::vector<Tensor<Dim>>& stress, Points<Dim>& force) {
    const NodeToCells& around = *patches.around;
    if (patches.nCells() == 0) return;
#pragma omp parallel for schedule(static) if (patches.nCells() > shortLoop)
    for (int i = 0; i < patches.nNodes(); ++i)
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const auto& g = patches.element[around.cell[s]];
            force[i] += g.measure * (stress[around.cell[s]] * g.gradN[around.corner[s]]);
        }
}

template <int Dim>
void addPressureForce(const Patches<Dim>& patches, const std::vector<double>& p, Points<Dim>& force) {
    const NodeToCells& around = *patches.around;
    std::vector<double> whole(patches.nCells());  // |e| times the mean pressure
#pragma omp parallel if (patches.nCells() > shortLoop)
    {
#pragma omp for schedule(static)
        for (int e = 0; e < patches.nCells(); ++e) {
            double sum = 0;
            for (int node : patches.cell(e)) sum += p[node];
            whole[e] = patches.element[e].measure * sum / (Dim + 1);
        }
#pragma omp for schedule(static)
        for (int i = 0; i < patches.nNodes(); ++i)
            for (int s = around.start[i]; s < around.start[i + 1]; ++s)
                force[i] -= whole[around.cell[s]] * patches.element[around.cell[s]].gradN[around.corner[s]];
    }
}

#define PFEM_INSTANTIATE(D)                                                                                  \
    template Patches<D> makePatches<D>(const std::vector<Simplex<D>>&, const NodeToCells&, const Points<D>&, \
                                       Integration);                                                         \
    template void updatePatches<D>(Patches<D>&, const Points<D>&);                                           \
    template void updateVolumes<D>(Patches<D>&);                                                             \
    template std::vector<Tensor<D>> elementGradient<D>(const Patches<D>&, const Points<D>&);                 \
    template std::vector<Tensor<D>> nodalMean<D>(const Patches<D>&, const std::vector<Tensor<D>>&);          \
    template std::vector<Stress<D>> nodalMean<D>(const Patches<D>&, const std::vector<Stress<D>>&);          \
    template std::vector<Tensor<D>> elementMean<D>(const Patches<D>&, const std::vector<Tensor<D>>&);        \
    template std::vector<Stress<D>> elementMean<D>(const Patches<D>&, const std::vector<Stress<D>>&);        \
    template std::vector<double> elementMean<D>(const Patches<D>&, const std::vector<double>&);              \
    template void addPressureForce<D>(const Patches<D>&, const std::vector<double>&, Points<D>&);            \
    template void addInternalForce<D>(const Patches<D>&, const std::vector<Tensor<D>>&, Points<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
