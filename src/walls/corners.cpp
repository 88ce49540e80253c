#include "walls/corners.hpp"

#include "walls/wallLine.hpp"

namespace pfem {

bool isConcaveEnd(const Topology<2>& topology, const Points<2>& x, int w, bool atEnd) {
    const WallLine line(x, topology.walls[w].nodes);
    const int corner = topology.walls[w].nodes[atEnd ? 1 : 0];
    if (topology.onSolid[corner] || topology.onWall[corner]) return true;
    for (int other = 0; other < static_cast<int>(topology.walls.size()); ++other) {
        const auto& face = topology.walls[other].nodes;
        if (other == w || topology.walls[other].patch < 0 || face[atEnd ? 0 : 1] != corner) continue;
        const WallLine next(x, face);
        return line.distance(next.start + 0.5 * next.length * next.tangent) > -1e-9 * next.length;
    }
    return false;
}

}  // namespace pfem
