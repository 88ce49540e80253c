#include "remesh/giveWay.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// a_I: how the volume of the cells grows when the node moves; zero inside.
template <int Dim>
Vec<Dim> outwardArea(const Topology<Dim>& topology, const std::vector<Simplex<Dim>>& cells, const Points<Dim>& x, int i) {
    Vec<Dim> area = Vec<Dim>::Zero();
    for (int s = topology.fluid.start[i]; s < topology.fluid.start[i + 1]; ++s)
        area -= faceArea<Dim>(x, oppositeFace<Dim>(cells[topology.fluid.cell[s]], topology.fluid.corner[s])) / Dim;
    return area;
}

/// In which directions the node may move: freely, or along the wall that it slides along.
template <int Dim>
Vec<Dim> allowed(const Topology<Dim>& topology, const Nodes<Dim>& nodes, int i, const Vec<Dim>& direction) {
    if (nodes.wall[i] < 0) return direction;
    const Vec<Dim> n = faceArea<Dim>(nodes.x, topology.walls[nodes.wall[i]].nodes).normalized();
    return direction - direction.dot(n) * n;
}

template <int Dim>
Vec<Dim> shift(const RemeshingControls& controls, const Topology<Dim>& topology, const State<Dim>& state, int i,
                double lost) {
    const auto& nodes = state.nodes;
    const double limit = controls.surfaceShift * nodes.h[i];
    const Vec<Dim> area = allowed<Dim>(topology, nodes, i, outwardArea<Dim>(topology, state.mesh.fluid.nodes, nodes.x, i));
    const double size = area.norm();
    if (std::abs(lost) >= limit * size) return size > 0 ? Vec<Dim>(area * (std::copysign(limit, lost) / size)) : area;
    return area * (lost / (size * size));
}

}  // namespace

template <int Dim>
void giveWay(const RemeshingControls& controls, const Topology<Dim>& topology,
             const std::vector<double>& returned, State<Dim>& state) {
    if (controls.surfaceShift == 0) return;
    auto& nodes = state.nodes;
    const auto& cells = state.mesh.fluid.nodes;
    std::vector<int> surface;
    for (int i = 0; i < nodes.size(); ++i)
        if (topology.freeSurface[i] && !topology.held(i)) surface.push_back(i);
    const Points<Dim> x = nodes.x;
    std::vector<unsigned char> stays(nodes.size(), 0);
    Points<Dim> dx(surface.size());
    forEach(static_cast<int>(surface.size()), [&](int k) { dx[k] = shift<Dim>(controls, topology, state, surface[k], nodes.lostVolume[surface[k]] - returned[surface[k]]); });
    for (bool done = false; !done;) {
        done = true;
        for (std::size_t k = 0; k < surface.size(); ++k)
            nodes.x[surface[k]] = stays[surface[k]] ? x[surface[k]] : Vec<Dim>(x[surface[k]] + dx[k]);
        for (int i : surface)
            for (int s = topology.fluid.start[i]; !stays[i] && s < topology.fluid.start[i + 1]; ++s) {
                const auto& cell = cells[topology.fluid.cell[s]];
                if (simplexMeasure<Dim>(nodes.x, cell) >= 0.5 * simplexMeasure<Dim>(x, cell)) continue;
                for (int node : cell) stays[node] = 1;
                done = false;
            }
    }
}

template void giveWay<2>(const RemeshingControls&, const Topology<2>&, const std::vector<double>&, State<2>&);

}  // namespace pfem
