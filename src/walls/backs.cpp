#include "walls/backs.hpp"

#include <algorithm>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "mesh/onFace.hpp"
#include "mesh/wallScreen.hpp"

namespace pfem {

namespace {

constexpr double off = 0.7;    // of h: a regular tetrahedron on the wall reaches 0.41 h behind it
constexpr double most = 0.25;  // of h in a step

}  // namespace

template <int Dim>
void keepOffBacks(const Topology<Dim>& topology, Nodes<Dim>& nodes) {
    const Points<Dim> x = nodes.x;
    const WallScreen<Dim> screen(topology, x);
    parallelFor(nodes.size(), [&](int i) {
        if (!topology.ofFluid(i) || isSupported(nodes.wall[i])) return;
        const auto back = screen.backAt({x[i], nodes.wall[i]}, off * nodes.h[i], WallScreen<Dim>::detour * nodes.h[i]);
        if (!back) return;
        const double distance = back->normal.dot(back->x - x[i]);
        nodes.x[i] -= std::clamp(off * nodes.h[i] - distance, 0.0, most * nodes.h[i]) * back->normal;
        const Face<Dim>& face = topology.walls[back->face].nodes;
        const double towards = (nodes.v[i] - onFace<Dim>(x, face, back->x, nodes.v)).dot(back->normal);
        if (towards > 0) nodes.v[i] -= towards * back->normal;
    });
}

template void keepOffBacks<2>(const Topology<2>&, Nodes<2>&);
template void keepOffBacks<3>(const Topology<3>&, Nodes<3>&);

}  // namespace pfem
