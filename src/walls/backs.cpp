#include "walls/backs.hpp"

#include <algorithm>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "mesh/onFace.hpp"
#include "mesh/wallScreen.hpp"

namespace pfem {

namespace {

constexpr double off = 0.7;     // of h: a regular tetrahedron on the wall reaches 0.41 h behind it
constexpr double least = 0.01;  // of h: on a bent wall that has let it go it is no nearer
constexpr double pace = 0.25;   // of h, at most at once

}  // namespace

template <int Dim>
void keepOffBacks(const Topology<Dim>& topology, Nodes<Dim>& nodes) {
    const Points<Dim> x = nodes.x;
    const WallScreen<Dim> screen(topology, x);
    parallelFor(nodes.size(), [&](int i) {
        if (!topology.ofFluid(i) || isSupported(nodes.wall[i])) return;
        const auto back =
            screen.backAt({x[i], nodes.wall[i]}, off * nodes.h[i], WallScreen<Dim>::shortDetour * nodes.h[i]);
        if (!back) return;
        const double h = nodes.h[i], distance = back->normal.dot(back->x - x[i]);
        if (distance < least * h) return;
        const Vec<Dim> away = x[i] - std::clamp(off * h - distance, 0.0, pace * h) * back->normal;
        if (!screen.parts({x[i], nodes.wall[i]}, {away, nodes.wall[i]}, least * h, 0)) nodes.x[i] = away;
        const Face<Dim>& face = topology.walls[back->face].nodes;
        const double towards = (nodes.v[i] - onFace<Dim>(x, face, back->x, nodes.v)).dot(back->normal);
        if (towards > 0) nodes.v[i] -= towards * back->normal;
    });
}

template void keepOffBacks<2>(const Topology<2>&, Nodes<2>&);
template void keepOffBacks<3>(const Topology<3>&, Nodes<3>&);

}  // namespace pfem
