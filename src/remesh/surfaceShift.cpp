#include "remesh/surfaceShift.hpp"

#include <algorithm>
#include <cmath>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "conditions/wallFreedom.hpp"
#include "mesh/simplex.hpp"
#include "remesh/handOn.hpp"

namespace pfem {

namespace {

/// Nodes of the free surface that may move.
template <int Dim>
std::vector<int> movableSurface(const Topology<Dim>& topology, const Mesh<Dim>& mesh) {
    const auto kept = keptNodes<Dim>(mesh, topology.nNodes());
    return parallelChosen(topology.nNodes(),
                          [&](int i) { return topology.freeSurface[i] && !kept[i] && !topology.onOpening(i); });
}

/// a_I = sum_e |e| grad N_I: how the volume of the cells grows when the node moves; on walls its part along them.
template <int Dim>
Vec<Dim> outwardArea(const Topology<Dim>& topology, const std::vector<Simplex<Dim>>& cells, const Nodes<Dim>& nodes,
                     int i) {
    Vec<Dim> area = Vec<Dim>::Zero();
    for (int s = topology.fluid.start[i]; s < topology.fluid.start[i + 1]; ++s)
        area -=
            faceArea<Dim>(nodes.x, oppositeFace<Dim>(cells[topology.fluid.cell[s]], topology.fluid.corner[s])) / Dim;
    return freedomOn<Dim>(topology.walls, nodes.x, nodes.wall[i]).project(area);
}

/// What each node is to bring: what it lacks, half of it shared with its neighbours along the surface. A zig-zag of the
/// surface hardly changes the volume of patches; what nodes lack in turns would only make it grow.
template <int Dim>
std::vector<double> sharedAlongSurface(const Topology<Dim>& topology, const std::vector<double>& lost) {
    // of each face to each of its nodes: half of all to two neighbours (2D), or to six by two faces each (3D)
    constexpr double share = Dim == 2 ? 0.25 : 1.0 / 24;
    std::vector<double> shared = lost;
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        for (int i : face.nodes)
            for (int j : face.nodes) shared[i] += share * (lost[j] - lost[i]);
    }
    return shared;
}

/// lost a/|a|^2, no longer than `limit`.
template <int Dim>
Vec<Dim> shift(double lost, const Vec<Dim>& area, double limit) {
    const double size = area.norm();
    if (size == 0) return Vec<Dim>::Zero();
    return area / size * (std::abs(lost) < limit * size ? lost / size : std::copysign(limit, lost));
}

/// Put the nodes of cells that would lose more than half of their volume, or become small by it, back to x, until there
/// is no such cell: one that is squeezed step by step would turn over. Returns the nodes that have been put back.
template <int Dim>
std::vector<int> holdBack(const NodeToCells& around, const std::vector<Simplex<Dim>>& cells,
                          const std::vector<int>& surface, const Nodes<Dim>& nodes, Points<Dim>& shifted) {
    constexpr double small = Dim == 2 ? 0.1 : 0.002;  // of h^Dim; a regular triangle has 0.43, a tetrahedron 0.118
    const Points<Dim>& x = nodes.x;
    const auto isSqueezed = [&](int i, const Simplex<Dim>& cell) {
        const double before = simplexMeasure<Dim>(x, cell), after = simplexMeasure<Dim>(shifted, cell);
        return !(after >= before || after >= std::max(0.5 * before, small * std::pow(nodes.h[i], Dim)));
    };
    std::vector<unsigned char> look(nodes.size());  // at the cells around these nodes
    std::vector<int> held;
    for (bool again = true; again;) {
        again = false;
        parallelFor(static_cast<int>(surface.size()), [&](int k) {
            const int i = surface[k];
            look[i] = 0;
            for (int s = around.start[i]; s < around.start[i + 1]; ++s) look[i] |= isSqueezed(i, cells[around.cell[s]]);
        });
        for (int i : surface)
            for (int s = around.start[i]; look[i] && s < around.start[i + 1]; ++s) {
                const auto& cell = cells[around.cell[s]];
                if (!isSqueezed(i, cell)) continue;
                for (int node : cell) {
                    if (shifted[node] == x[node]) continue;
                    again = true;
                    shifted[node] = x[node];
                    held.push_back(node);
                    for (int r = around.start[node]; r < around.start[node + 1]; ++r)  // all of them are other ones now
                        for (int other : cells[around.cell[r]]) look[other] = 1;
                }
            }
    }
    return held;
}

}  // namespace

template <int Dim>
void shiftSurface(const RemeshingControls& controls, const Topology<Dim>& topology, const std::vector<double>& returned,
                  double share, State<Dim>& state) {
    if (controls.surfaceShift == 0 || share == 0) return;
    Nodes<Dim>& nodes = state.nodes;
    const auto& cells = state.mesh.fluid.nodes;
    const auto surface = movableSurface<Dim>(topology, state.mesh);
    std::vector<double> lost = nodes.lostVolume;
    parallelFor(nodes.size(), [&](int i) { lost[i] = (lost[i] - returned[i]) * share; });
    auto wanted = sharedAlongSurface<Dim>(topology, lost);
    std::vector<Vec<Dim>> area(surface.size());
    std::vector<double> capacity(nodes.size(), 0.0);
    parallelFor(static_cast<int>(surface.size()), [&](int k) {
        const int i = surface[k];
        area[k] = outwardArea<Dim>(topology, cells, nodes, i);
        capacity[i] = controls.surfaceShift * nodes.h[i] * area[k].norm();
    });
    constexpr int turns = Dim == 2 ? 1 : 3;  // in space neighbours bring what a node cannot; films are wider there
    Points<Dim> shifted;
    for (int turn = 0; turn < turns; ++turn) {
        if constexpr (Dim == 3) {
            const auto before = wanted;
            handOn<Dim>(topology, state, capacity, wanted);
            parallelFor(nodes.size(), [&](int i) { nodes.lostVolume[i] += (wanted[i] - before[i]) / share; });
        }
        shifted = nodes.x;
        parallelFor(static_cast<int>(surface.size()), [&](int k) {
            const int i = surface[k];
            if (capacity[i] > 0) shifted[i] += shift<Dim>(wanted[i], area[k], controls.surfaceShift * nodes.h[i]);
        });
        const auto held = holdBack<Dim>(topology.fluid, cells, surface, nodes, shifted);
        if (held.empty()) break;
        for (const int i : held) capacity[i] = 0;
    }
    nodes.x = std::move(shifted);
}

#define PFEM_INSTANTIATE(D)                                                                                         \
    template void shiftSurface<D>(const RemeshingControls&, const Topology<D>&, const std::vector<double>&, double, \
                                  State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
