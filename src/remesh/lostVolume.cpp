#include "remesh/lostVolume.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "remesh/heirs.hpp"

namespace pfem {

namespace {

/// What nodes that went and places on walls and solids that fell dry lack, to their old neighbours. Returns
/// what found no heir.
template <int Dim>
double handOver(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex, const std::vector<unsigned char>& wet,
                std::vector<double>& lost) {
    double orphaned = 0;
    for (int i = 0; i < moved.topology.nNodes(); ++i) {
        const int node = newIndex[i];
        const bool dryPlace = node >= 0 && !moved.topology.ofFluid(i) && !wet[node];
        if (node >= 0 && !dryPlace) continue;
        const double amount = node < 0 ? moved.lostVolume[i] + moved.dropVolume[i] : lost[node];
        const auto heirs = heirsOf<Dim>(moved, newIndex, wet, i);
        for (int heir : heirs) lost[heir] += amount / static_cast<double>(heirs.size());
        if (heirs.empty()) orphaned += amount;
        if (dryPlace) lost[node] = 0;
    }
    return orphaned;
}

/// What removed surface nodes cut off or fill in, half to each of their neighbours: give(node, amount); returns the
/// sum.
template <int Dim, class Give>
double shareCuts(const MovedMesh<Dim>& moved, const NodePlan<Dim>& plan, const std::vector<int>& newIndex,
                 const Give& give) {
    double sum = 0;
    if constexpr (Dim == 2)
        for (const auto& cut : plan.cuts) {
            const double amount = -0.5 * simplexMeasure<2>(moved.x, cut);
            for (int end : {cut[0], cut[2]}) {
                if (newIndex[end] < 0) continue;
                give(newIndex[end], amount);
                sum += amount;
            }
        }
    return sum;
}

/// Old surface nodes that are still in the fluid; new indices.
template <int Dim>
std::vector<int> lastingSurface(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex,
                                const std::vector<unsigned char>& wet) {
    std::vector<int> surface;
    for (int i = 0; i < moved.topology.nNodes(); ++i)
        if (moved.topology.freeSurface[i] && newIndex[i] >= 0 && wet[newIndex[i]]) surface.push_back(newIndex[i]);
    return surface;
}

/// Nodes without triangles carry what they lack; those that have found one lack what they carried.
template <int Dim>
void exchangeWithDrops(const MovedMesh<Dim>& moved, const std::vector<int>& newIndex,
                       const std::vector<unsigned char>& wet, Nodes<Dim>& nodes) {
    for (int i = 0; i < moved.topology.nNodes(); ++i) {
        const int node = newIndex[i];
        if (node < 0) continue;
        const double both = nodes.dropVolume[node] + nodes.lostVolume[node];
        const bool drop = !wet[node] && moved.topology.ofFluid(i) && both > 0;
        nodes.dropVolume[node] = drop ? both : 0;
        nodes.lostVolume[node] = drop ? 0 : both;
    }
}

}  // namespace

template <int Dim>
void chargeMotion(const NodeToCells& around, const std::vector<Simplex<Dim>>& cells, const Points<Dim>& xOld,
                  Nodes<Dim>& nodes) {
    const int nCells = static_cast<int>(cells.size());
    std::vector<double> change(nCells), weight(nCells), pool(nCells);
    parallelFor(nCells, [&](int e) {
        const double now = simplexMeasure<Dim>(nodes.x, cells[e]);
        change[e] = (now - simplexMeasure<Dim>(xOld, cells[e])) / (Dim + 1);
        weight[e] = std::max(now, 0.0);
    });
    std::vector<double> intensity(nodes.size(), 0.0), volume(nodes.size(), 0.0);
    parallelFor(nodes.size(), [&](int i) {
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            nodes.lostVolume[i] -= change[around.cell[s]];
            volume[i] += weight[around.cell[s]];
        }
        if (volume[i] > 0) intensity[i] = nodes.lostVolume[i] / volume[i];
    });
    parallelFor(nCells, [&](int e) {
        for (int node : cells[e]) pool[e] += weight[e] * intensity[node] / (Dim + 1);
    });
    parallelFor(nodes.size(), [&](int i) {
        double sum = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) sum += pool[around.cell[s]];
        if (volume[i] > 0) nodes.lostVolume[i] = sum;
    });
}

template <int Dim>
void bookRemeshing(const MovedMesh<Dim>& moved, const NodePlan<Dim>& plan, const std::vector<int>& newIndex,
                   const std::vector<CellChange<Dim>>& changes, VolumeLedger& sheet, State<Dim>& state) {
    std::vector<double>& lost = state.nodes.lostVolume;
    const auto wet = nodesIn<Dim>(state.mesh.fluid.nodes, state.nodes.size());
    double reshaped = cellVolume<Dim>(state) - moved.volume;
    for (const auto cause : {VolumeCause::contact, VolumeCause::stretched, VolumeCause::released}) sheet.book(cause, 0);
    for (const auto& [cause, cell, amount] : changes) sheet.book(cause, cell, amount);
    for (int node = 0; node < state.nodes.size(); ++node) lost[node] -= sheet.atNodes()[node];
    for (const auto cause : {VolumeCause::contact, VolumeCause::stretched, VolumeCause::released})
        reshaped -= sheet[cause];

    sheet.book(VolumeCause::reshaped, reshaped);
    const double cuts = shareCuts<Dim>(moved, plan, newIndex, [&](int node, double amount) {
        sheet.place(VolumeCause::reshaped, node, amount);
        lost[node] -= amount;
    });
    const double orphaned = handOver(moved, newIndex, wet, lost);
    const auto surface = lastingSurface(moved, newIndex, wet);
    for (const int node : surface) lost[node] -= (reshaped - cuts - orphaned) / static_cast<double>(surface.size());
    const auto takers = surface.empty() ? chosen(wet) : surface;
    for (const int node : takers)
        sheet.place(VolumeCause::reshaped, node, (reshaped - cuts) / static_cast<double>(takers.size()));
    exchangeWithDrops(moved, newIndex, wet, state.nodes);
}

#define PFEM_INSTANTIATE(D)                                                                                         \
    template void chargeMotion<D>(const NodeToCells&, const std::vector<Simplex<D>>&, const Points<D>&, Nodes<D>&); \
    template void bookRemeshing<D>(const MovedMesh<D>&, const NodePlan<D>&, const std::vector<int>&,                \
                                   const std::vector<CellChange<D>>&, VolumeLedger&, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
