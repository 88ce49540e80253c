#include "walls/release.hpp"

#include <cmath>

#include "state/unseenPart.hpp"
#include "walls/wallLine.hpp"

namespace pfem {

namespace {

/// Where a node hangs at walls: the wall's velocity and the mean normal of all that hold it.
struct Grip {
    Vec<2> velocity = Vec<2>::Zero(), inward = Vec<2>::Zero();

    Grip(const Topology<2>& topology, const Nodes<2>& nodes, int i) {
        const int count = nSupports(nodes.wall[i]);
        for (int k = 0; k < count; ++k) {
            const Face<2>& face = topology.walls[nodes.wall[i][k]].nodes;
            const WallLine line(nodes.x, face);
            velocity += line.between(line.along(nodes.x[i]), nodes.v, face) / count;
            inward += line.inward;
        }
        inward.normalize();
    }
};

/// A drop leaves walls from which gravity pulls it; what the walls' acceleration is, is the normal part of a.
void letDropFall(const Topology<2>& topology, const Vec<2>& gravity, int i, Nodes<2>& nodes) {
    for (const int wall : Supports<2>(nodes.wall[i]))
        if (wall >= 0 &&
            (gravity - nodes.a[i]).dot(inwardNormal<2>(nodes.x, topology.walls[wall].nodes)) > 1e-9 * gravity.norm())
            dropSupport(nodes.wall[i], wall);
}

}  // namespace

template <>
void releaseFromWalls<2>(const WallControls& controls, const Topology<2>& topology, const Vec<2>& gravity,
                         const ViscousFluid& fluid, double dt, Nodes<2>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        if (!topology.onWall[i]) continue;
        const Grip grip(topology, nodes, i);
        const Vec<2> slip = nodes.v[i] - grip.velocity;
        const double rate = slip.norm() / nodes.h[i];
        const double scale = fluid.rho * (gravity.norm() * nodes.h[i] + 0.5 * slip.squaredNorm() +
                                          unseenPart * std::pow(nodes.h[i] / dt, 2)) +
                             fluid.law->viscosity(rate, nodes.p[i]) * rate;
        if (topology.isolated(i)) letDropFall(topology, gravity, i, nodes);
        const bool pulledOff = topology.freeSurface[i] && -nodes.p[i] > controls.wallTension * scale;
        if (pulledOff) nodes.wall[i] = unsupported<2>();
        if (isSupported(nodes.wall[i])) continue;
        nodes.p[i] = 0;
        nodes.x[i] += 1e-3 * nodes.h[i] * grip.inward;
    }
}

}  // namespace pfem
