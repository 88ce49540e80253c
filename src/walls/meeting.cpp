#include "walls/meeting.hpp"

#include <cmath>

#include "walls/wallLine.hpp"

namespace pfem {

namespace {

/// The local edge of `wall` beyond which `other` follows, -1: none.
int edgeTo(const Topology<2>& topology, int wall, int other) {
    for (int k = 0; k < 2; ++k)
        if (topology.walls[wall].next[k] == other) return k;
    return -1;
}

}  // namespace

std::optional<Vec<2>> meetingOf(const Topology<2>& topology, const Points<2>& x, int wall, int other, double slack) {
    const Face<2>& face = topology.walls[wall].nodes;
    if (const int k = edgeTo(topology, wall, other); k >= 0) return x[face[1 - k]];
    const WallLine own(x, face), line(x, topology.walls[other].nodes);
    const double across = own.tangent.dot(line.inward);
    if (std::abs(across) < 1e-3) return std::nullopt;
    const double s = -line.distance(own.start) / across;
    const Vec<2> place = own.start + s * own.tangent;
    const double t = line.along(place);
    const bool within = s > -slack && s < own.length + slack && t > -slack && t < line.length + slack;
    return within ? std::optional<Vec<2>>(place) : std::nullopt;
}

bool isConvexEnd(const Topology<2>& topology, int wall, int other) {
    const int k = edgeTo(topology, wall, other);
    return k >= 0 && topology.walls[wall].bend[k] == Bend::convex;
}

}  // namespace pfem
