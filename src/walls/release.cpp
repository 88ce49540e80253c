#include "walls/release.hpp"

#include <cmath>

#include "state/unseenPart.hpp"
#include "walls/wallLine.hpp"

namespace pfem {

template <>
void releaseFromWalls<2>(const WallControls& controls, const Topology<2>& topology, const Vec<2>& gravity,
                         const ViscousFluid& fluid, double dt, Nodes<2>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        if (nodes.wall[i] < 0 || topology.corner[i]) continue;
        const Face<2>& face = topology.walls[nodes.wall[i]].nodes;
        const WallLine line(nodes.x, face);
        const Vec<2> slip = nodes.v[i] - line.between(line.along(nodes.x[i]), nodes.v, face);
        const double rate = slip.norm() / nodes.h[i];
        const double scale = fluid.rho * (gravity.norm() * nodes.h[i] + 0.5 * slip.squaredNorm() +
                                          unseenPart * std::pow(nodes.h[i] / dt, 2)) +
                             fluid.law->viscosity(rate, nodes.p[i]) * rate;
        const bool pulledOff =  // the wall's acceleration is the normal part of a
            topology.isolated(i) && (gravity - nodes.a[i]).dot(line.inward) > 1e-9 * gravity.norm();
        if (!pulledOff && !(topology.freeSurface[i] && -nodes.p[i] > controls.wallTension * scale)) continue;
        nodes.wall[i] = -1;
        nodes.p[i] = 0;
        nodes.x[i] += 1e-3 * nodes.h[i] * line.inward;
    }
}

}  // namespace pfem
