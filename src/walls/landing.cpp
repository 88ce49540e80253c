#include "walls/landing.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/parallel.hpp"
#include "walls/corners.hpp"
#include "walls/tJunctions.hpp"
#include "walls/wallLine.hpp"

namespace pfem {

namespace {

/// Put node i on the wall face w at distance s from its start; there it moves along with the wall.
void land(const WallLine& line, int w, double s, const Topology<2>& topology, Nodes<2>& nodes, int i) {
    const Face<2>& face = topology.walls[w].nodes;
    s = std::clamp(s, 0.0, line.length);
    const auto alongWith = [&](const Vec<2>& own, const Vec<2>& ofWall) -> Vec<2> {
        const Vec<2> along = line.tangent * line.tangent.dot(own);
        const double normal = line.inward.dot(ofWall);
        return normal == 0 ? along : Vec<2>(along + normal * line.inward);
    };
    nodes.x[i] = line.start + s * line.tangent;
    nodes.v[i] = alongWith(nodes.v[i], line.between(s, nodes.v, face));
    nodes.a[i] = alongWith(nodes.a[i], line.between(s, nodes.a, face));
    nodes.wall[i] = w;
}

/// Where a node lands on a wall, how far from its start and after which part of its way.
struct Landing {
    double part = std::numeric_limits<double>::max();  // it does not
    double place = 0;
    int wall = -1;
};

/// The landing of a node on its way from xOld to x on a wall, `line` now and before: it has crossed the wall or is
/// within distance h of it. What is part of the fluid is put on the wall where it is; a drop, whose way may be many h
/// long, where it has crossed it.
Landing landingOn(const std::array<WallLine, 2>& line, const Vec<2>& xOld, const Vec<2>& x, double h, double distance,
                  bool drop) {
    const double after = line[0].distance(x), before = line[1].distance(xOld);
    if (after > distance * h || before < -1e-9 * h || after >= before) return {};  // far, was behind, or leaves
    Landing landing;
    landing.part = drop && after < 0 ? std::max(0.0, before / (before - after)) : 1;
    landing.place = line[0].along(x);
    if (landing.part < 1) landing.place = line[1].along(xOld) + landing.part * (landing.place - line[1].along(xOld));
    return landing.place >= 0 && landing.place <= line[0].length ? landing : Landing{};
}

}  // namespace

template <>
void landOnWalls<2>(const WallControls& controls, const Topology<2>& topology, const Points<2>& xOld, State<2>& state) {
    Nodes<2>& nodes = state.nodes;
    const TJunctions feet(topology, nodes);
    for (int i = 0; i < nodes.size(); ++i) {
        const int w = nodes.wall[i];
        if (topology.onSolidOrCorner(i) || w < 0) continue;
        const WallLine line(nodes.x, topology.walls[w].nodes);
        const double s = feet.stop(topology, w, xOld, nodes, i, line.along(nodes.x[i]));
        if ((s < 0 || s > line.length) && !isConcaveEnd(topology, nodes.x, w, s > 0))
            nodes.wall[i] = -1;
        else
            land(line, w, s, topology, nodes, i);  // also removes the round-off
    }
    std::vector<std::pair<int, std::array<WallLine, 2>>> walls;  // now and before
    for (int w = 0; w < static_cast<int>(topology.walls.size()); ++w)
        if (topology.walls[w].patch >= 0)
            walls.push_back({w, {WallLine(nodes.x, topology.walls[w].nodes), WallLine(xOld, topology.walls[w].nodes)}});
    parallelFor(nodes.size(), [&](int i) {  // walls have their corners, which do not land
        if (topology.onSolidOrCorner(i) || topology.onWall[i] || nodes.wall[i] >= 0) return;
        const bool drop = topology.isolated(i);
        Landing first;
        const std::array<WallLine, 2>* line = nullptr;
        for (const auto& [w, lines] : walls) {
            const Landing landing = landingOn(lines, xOld[i], nodes.x[i], nodes.h[i], controls.landingDistance, drop);
            if (landing.part >= first.part) continue;
            first = landing;
            first.wall = w;
            line = &lines;
        }
        if (first.wall < 0) return;
        if (!drop) first.place = feet.stop(topology, first.wall, xOld, nodes, i, first.place);
        land((*line)[0], first.wall, first.place, topology, nodes, i);
    });
}

}  // namespace pfem
