#include "remesh/joinDrops.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "mesh/simplex.hpp"
#include "mesh/wallScreen.hpp"

namespace pfem {

namespace {

/// Loose nodes by their first coordinate.
template <int Dim>
std::vector<std::pair<double, int>> sortedDrops(const State<Dim>& state) {
    const auto loose = looseNodes<Dim>(state.mesh, state.nodes.size());
    std::vector<std::pair<double, int>> drops;
    for (int i = 0; i < state.nodes.size(); ++i)
        if (loose[i]) drops.emplace_back(state.nodes.x[i][0], i);
    std::sort(drops.begin(), drops.end());
    return drops;
}

template <int Dim>
double patchVolume(const MovedMesh<Dim>& moved, int i) {
    double volume = 0;
    const auto& around = moved.topology.fluid;
    for (int s = around.start[i]; s < around.start[i + 1]; ++s)
        volume += simplexMeasure<Dim>(moved.x, moved.fluid[around.cell[s]]) / (Dim + 1);
    return volume;
}

/// Is there a wall between two nodes?
template <int Dim>
bool isApart(const WallScreen<Dim>& screen, const MovedMesh<Dim>& moved, int i, int j) {
    const auto& walls = moved.topology.supports;
    const HeldPoint<Dim> a{moved.x[i], walls[i]}, b{moved.x[j], walls[j]};
    const double slack = 1e-6 * (a.x - b.x).norm();
    return screen.parts(a, b, slack, 0) || screen.parts(b, a, slack, 0);
}

/// An inelastic impact: both go on with the common velocity.
template <int Dim>
void giveMomentum(const MovedMesh<Dim>& moved, int drop, int node, Nodes<Dim>& nodes) {
    const double ofNode = patchVolume<Dim>(moved, node), ofDrop = moved.dropVolume[drop];
    if (!moved.topology.ofFluid(node) || !(ofNode > 0 && ofDrop > 0)) return;
    nodes.v[node] += ofDrop / (ofNode + ofDrop) * (nodes.v[drop] - nodes.v[node]);
}

}  // namespace

template <int Dim>
void joinDrops(const RemeshingControls& controls, MovedMesh<Dim>& moved, State<Dim>& state) {
    Nodes<Dim>& nodes = state.nodes;
    moved.joins.assign(nodes.size(), -1);
    const auto drops = sortedDrops<Dim>(state);
    const double limit = std::min(controls.expert.removeDistanceFilm, controls.removeDistanceSurface);
    std::optional<WallScreen<Dim>> screen;  // few drops need it
    for (int i = 0; !drops.empty() && i < nodes.size(); ++i) {
        if (!moved.topology.wet(i)) continue;
        const double x = nodes.x[i][0], widest = limit * nodes.h[i];
        for (auto it = std::lower_bound(drops.begin(), drops.end(), std::pair(x - widest, -1));
             it != drops.end() && it->first <= x + widest; ++it) {
            const int drop = it->second;
            const Vec<Dim> apart = nodes.x[drop] - nodes.x[i];
            if (moved.images.isImage(drop) || moved.joins[drop] >= 0 || apart.norm() >= widest ||
                apart.dot(nodes.v[drop] - nodes.v[i]) >= 0)
                continue;
            if (!screen) screen.emplace(moved.topology, moved.x);
            if (isApart<Dim>(*screen, moved, i, drop)) continue;
            moved.joins[drop] = moved.images.own(i);
            giveMomentum<Dim>(moved, drop, moved.joins[drop], nodes);
        }
    }
}

template <int Dim>
std::vector<int> squeezeDrops(const std::vector<int>& pinched, MovedMesh<Dim>& moved) {
    const auto& topology = moved.topology;
    std::vector<unsigned char> goes(moved.x.size(), 0);
    for (const int i : pinched) goes[i] = 1;
    std::vector<int> homeless;
    for (const int drop : pinched) {
        int& heir = moved.joins[drop];
        if (!topology.isolated(drop) || heir >= 0 || moved.gone[drop] > 0 || moved.images.isImage(drop)) continue;
        double nearest = std::numeric_limits<double>::max();
        for (int i = 0; i < topology.nNodes(); ++i) {
            const double distance = (moved.x[i] - moved.x[drop]).norm();
            if (distance >= nearest || goes[i] || !topology.wet(i) || topology.onWall[i] || topology.onSolid[i])
                continue;
            nearest = distance;
            heir = moved.images.own(i);
        }
        if (heir >= 0) continue;
        std::swap(moved.gone[drop], moved.dropVolume[drop]);
        homeless.push_back(drop);
    }
    return homeless;
}

#define PFEM_INSTANTIATE(D)                                                         \
    template void joinDrops<D>(const RemeshingControls&, MovedMesh<D>&, State<D>&); \
    template std::vector<int> squeezeDrops<D>(const std::vector<int>&, MovedMesh<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
