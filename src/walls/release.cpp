#include "walls/release.hpp"

#include <cmath>

#include "mesh/onFace.hpp"
#include "state/unseenPart.hpp"

namespace pfem {

namespace {

/// Where a node hangs at walls: the wall's velocity and the mean normal of all that hold it.
template <int Dim>
struct Grip {
    Vec<Dim> velocity = Vec<Dim>::Zero(), inward = Vec<Dim>::Zero();

    Grip(const Topology<Dim>& topology, const Nodes<Dim>& nodes, int i) {
        const int count = nSupports(nodes.wall[i]);
        for (int k = 0; k < count; ++k) {
            const Face<Dim>& face = topology.walls[nodes.wall[i][k]].nodes;
            velocity += onFace<Dim>(nodes.x, face, nodes.x[i], nodes.v) / count;
            inward += inwardNormal<Dim>(nodes.x, face);
        }
        inward.normalize();
    }
};

/// A node goes on along the tangent of a bent wall, by which it is behind a hollow one: back onto it, where the step
/// off the wall does not make up for it.
template <int Dim>
void backToCurves(const Topology<Dim>& topology, const Supports<Dim>& held, double off, const Points<Dim>& x,
                  Vec<Dim>& node) {
    for (const int wall : held) {
        if (wall < 0 || !topology.walls[wall].bent) continue;
        const auto place = placeOnRegion<Dim>(topology.walls, x, wall, node);
        if (place.normal.dot(node - place.x) < -off) node = place.x;
    }
}

/// A drop leaves walls from which gravity pulls it; what the walls' acceleration is, is the normal part of a.
template <int Dim>
void letDropFall(const Topology<Dim>& topology, const Vec<Dim>& gravity, int i, Nodes<Dim>& nodes) {
    for (const int wall : Supports<Dim>(nodes.wall[i]))
        if (wall >= 0 &&
            (gravity - nodes.a[i]).dot(inwardNormal<Dim>(nodes.x, topology.walls[wall].nodes)) > 1e-9 * gravity.norm())
            dropSupport(nodes.wall[i], wall);
}

}  // namespace

template <int Dim>
void releaseFromWalls(const WallControls& controls, const Topology<Dim>& topology, const Vec<Dim>& gravity,
                      const ViscousFluid& fluid, double dt, Nodes<Dim>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        if (!topology.onWall[i] || topology.onOpening(i)) continue;
        const Grip<Dim> grip(topology, nodes, i);
        const Supports<Dim> held = nodes.wall[i];
        const Vec<Dim> slip = nodes.v[i] - grip.velocity;
        const double rate = slip.norm() / nodes.h[i];
        const double scale = fluid.rho * (gravity.norm() * nodes.h[i] + 0.5 * slip.squaredNorm() +
                                          unseenPart * std::pow(nodes.h[i] / dt, 2)) +
                             fluid.law->viscosity(rate, nodes.p[i]) * rate;
        if (topology.isolated(i)) letDropFall<Dim>(topology, gravity, i, nodes);
        const bool pulledOff = topology.freeSurface[i] && -nodes.p[i] > controls.wallTension * scale;
        if (pulledOff) nodes.wall[i] = unsupported<Dim>();
        if (isSupported(nodes.wall[i])) continue;
        nodes.p[i] = 0;
        const double off = 1e-3 * nodes.h[i];
        backToCurves<Dim>(topology, held, off, nodes.x, nodes.x[i]);
        nodes.x[i] += off * grip.inward;
    }
}

#define PFEM_INSTANTIATE(D)                                                                                        \
    template void releaseFromWalls<D>(const WallControls&, const Topology<D>&, const Vec<D>&, const ViscousFluid&, \
                                      double, Nodes<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
