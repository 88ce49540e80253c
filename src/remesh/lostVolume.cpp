#include "remesh/lostVolume.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "remesh/heirs.hpp"

namespace pfem {

namespace {

/// What nodes that went and places on walls and solids that fell dry lack, to their old neighbours. Returns
/// what found no heir.
double handOver(const MovedMesh<2>& moved, const std::vector<int>& newIndex, const std::vector<unsigned char>& wet,
                std::vector<double>& lost) {
    double orphaned = 0;
    for (int i = 0; i < moved.topology.nNodes(); ++i) {
        const int node = newIndex[i];
        const bool dryPlace = node >= 0 && moved.topology.held(i) && !wet[node];
        if (node >= 0 && !dryPlace) continue;
        const double amount = node < 0 ? moved.lostVolume[i] + moved.dropVolume[i] : lost[node];
        const auto heirs = heirsOf<2>(moved, newIndex, wet, i);
        for (int heir : heirs) lost[heir] += amount / static_cast<double>(heirs.size());
        if (heirs.empty()) orphaned += amount;
        if (dryPlace) lost[node] = 0;
    }
    return orphaned;
}

/// What removed surface nodes cut off or fill in; returns the sum.
double chargeCuts(const MovedMesh<2>& moved, const NodePlan<2>& plan, const std::vector<int>& newIndex,
                  std::vector<double>& lost) {
    double sum = 0;
    for (const auto& cut : plan.cuts) {
        const double area = simplexMeasure<2>(moved.x, cut);
        for (int end : {cut[0], cut[2]})
            if (newIndex[end] >= 0) {
                lost[newIndex[end]] += 0.5 * area;
                sum -= 0.5 * area;
            }
    }
    return sum;
}

/// Old surface nodes that are still in the fluid; new indices.
std::vector<int> lastingSurface(const MovedMesh<2>& moved, const std::vector<int>& newIndex,
                                const std::vector<unsigned char>& wet) {
    std::vector<int> surface;
    for (int i = 0; i < moved.topology.nNodes(); ++i)
        if (moved.topology.freeSurface[i] && newIndex[i] >= 0 && wet[newIndex[i]]) surface.push_back(newIndex[i]);
    return surface;
}

/// An even share of what appeared for each of the nodes.
void chargeEvenly(const std::vector<int>& nodes, double change, std::vector<double>& lost) {
    for (int node : nodes) lost[node] -= change / static_cast<double>(nodes.size());
}

/// Nodes without triangles carry what they lack; those that have found one lack what they carried.
void exchangeWithDrops(const MovedMesh<2>& moved, const std::vector<int>& newIndex,
                       const std::vector<unsigned char>& wet, Nodes<2>& nodes) {
    for (int i = 0; i < moved.topology.nNodes(); ++i) {
        const int node = newIndex[i];
        if (node < 0) continue;
        const double both = nodes.dropVolume[node] + nodes.lostVolume[node];
        const bool drop = !wet[node] && !moved.topology.held(i) && both > 0;
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
    forEach(nCells, [&](int e) {
        const double now = simplexMeasure<Dim>(nodes.x, cells[e]);
        change[e] = (now - simplexMeasure<Dim>(xOld, cells[e])) / (Dim + 1);
        weight[e] = std::max(now, 0.0);
    });
    std::vector<double> intensity(nodes.size(), 0.0), volume(nodes.size(), 0.0);
    forEach(nodes.size(), [&](int i) {
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            nodes.lostVolume[i] -= change[around.cell[s]];
            volume[i] += weight[around.cell[s]];
        }
        if (volume[i] > 0) intensity[i] = nodes.lostVolume[i] / volume[i];
    });
    forEach(nCells, [&](int e) {
        for (int node : cells[e]) pool[e] += weight[e] * intensity[node] / (Dim + 1);
    });
    forEach(nodes.size(), [&](int i) {
        double sum = 0;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) sum += pool[around.cell[s]];
        if (volume[i] > 0) nodes.lostVolume[i] = sum;
    });
}

void chargeRemeshing(const MovedMesh<2>& moved, const NodePlan<2>& plan, const std::vector<int>& newIndex,
                     const Connectivity& selected, double change, State<2>& state) {
    std::vector<double>& lost = state.nodes.lostVolume;
    const auto wet = nodesIn<2>(selected.fluid, state.nodes.size());
    for (int node = 0; node < state.nodes.size(); ++node) lost[node] -= selected.gained[node];
    const double cuts = chargeCuts(moved, plan, newIndex, lost);
    const double rest = change - selected.contact + selected.stretched + selected.released - cuts;
    const double orphaned = handOver(moved, newIndex, wet, lost);
    chargeEvenly(lastingSurface(moved, newIndex, wet), rest - orphaned, lost);
    exchangeWithDrops(moved, newIndex, wet, state.nodes);
}

std::vector<double> reshapedShares(const MovedMesh<2>& moved, const NodePlan<2>& plan, const std::vector<int>& newIndex,
                                   const Connectivity& selected, double reshaped, int nNodes) {
    std::vector<double> shares(nNodes, 0.0);  // as lost
    const double cuts = chargeCuts(moved, plan, newIndex, shares);
    const auto wet = nodesIn<2>(selected.fluid, nNodes);
    auto takers = lastingSurface(moved, newIndex, wet);
    if (takers.empty())  // no surface is left: all of the fluid
        for (int node = 0; node < nNodes; ++node)
            if (wet[node]) takers.push_back(node);
    chargeEvenly(takers, reshaped - cuts, shares);
    for (double& share : shares) share = -share;
    return shares;
}

template void chargeMotion<2>(const NodeToCells&, const std::vector<Simplex<2>>&, const Points<2>&, Nodes<2>&);

}  // namespace pfem
