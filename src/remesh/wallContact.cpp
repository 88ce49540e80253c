#include "remesh/wallContact.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "material/viscosity.hpp"
#include "mesh/simplex.hpp"
#include "momentum/newmark.hpp"
#include "remesh/movedMesh.hpp"

namespace pfem {

namespace {

/// A wall face as start, unit tangent, length and normal into the fluid.
struct Line {
    Vec<2> start, tangent, inward;
    double length;

    Line(const Points<2>& x, const Face<2>& face) : start(x[face[0]]), tangent(x[face[1]] - x[face[0]]) {
        length = tangent.norm();
        tangent /= length;
        inward = {-tangent[1], tangent[0]};  // fluid on the left
    }
    double along(const Vec<2>& p) const { return tangent.dot(p - start); }
    double distance(const Vec<2>& p) const { return inward.dot(p - start); }
    /// The values at the face's ends, interpolated.
    Vec<2> between(double s, const Points<2>& value, const Face<2>& face) const {
        return (1 - s / length) * value[face[0]] + s / length * value[face[1]];
    }
};

/// Put node i on the wall face w at distance s from its start; there it moves along with the wall.
void land(const Line& line, int w, double s, const Topology<2>& topology, Nodes<2>& nodes, int i) {
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
Landing landingOn(const std::array<Line, 2>& line, const Vec<2>& xOld, const Vec<2>& x, double h, double distance,
                  bool drop) {
    const double after = line[0].distance(x), before = line[1].distance(xOld);
    if (after > distance * h || before < -1e-9 * h || after >= before) return {};  // far, was behind, or leaves
    Landing landing;
    landing.part = drop && after < 0 ? std::max(0.0, before / (before - after)) : 1;
    landing.place = line[0].along(x);
    if (landing.part < 1) landing.place = line[1].along(xOld) + landing.part * (landing.place - line[1].along(xOld));
    return landing.place >= 0 && landing.place <= line[0].length ? landing : Landing{};
}

/// Feet of other walls, which nothing that slides on the same face can pass.
class Feet {
public:
    Feet(const Topology<2>& topology, const Nodes<2>& nodes) {
        for (int i = 0; i < nodes.size(); ++i)
            if (topology.corner[i] && nodes.wall[i] >= 0) feet_.push_back(i);
    }

    /// Where on face w a node stops that was at xOld and has come to s.
    double stop(const Topology<2>& topology, int w, const Points<2>& xOld, const Nodes<2>& nodes, int i,
                double s) const {
        for (int foot : feet_) {
            if (nodes.wall[foot] != w) continue;
            const Line now(nodes.x, topology.walls[w].nodes), before(xOld, topology.walls[w].nodes);
            const double place = now.along(nodes.x[foot]);
            const bool wasAfter = before.along(xOld[i]) >= before.along(xOld[foot]);
            if ((s >= place) != wasAfter) s = place;
        }
        return s;
    }

private:
    std::vector<int> feet_;
};

}  // namespace

bool isConcaveEnd(const Topology<2>& topology, const Points<2>& x, int w, bool atEnd) {
    const Line line(x, topology.walls[w].nodes);
    const int corner = topology.walls[w].nodes[atEnd ? 1 : 0];
    if (topology.onSolid[corner] || topology.onWall[corner]) return true;
    for (int other = 0; other < static_cast<int>(topology.walls.size()); ++other) {
        const auto& face = topology.walls[other].nodes;
        if (other == w || topology.walls[other].patch < 0 || face[atEnd ? 0 : 1] != corner) continue;
        const Line next(x, face);
        return line.distance(next.start + 0.5 * next.length * next.tangent) > -1e-9 * next.length;
    }
    return false;
}

template <>
void landOnWalls<2>(const RemeshingControls& controls, const Topology<2>& topology, const Points<2>& xOld,
                    State<2>& state) {
    Nodes<2>& nodes = state.nodes;
    const Feet feet(topology, nodes);
    for (int i = 0; i < nodes.size(); ++i) {
        const int w = nodes.wall[i];
        if (topology.held(i) || w < 0) continue;
        const Line line(nodes.x, topology.walls[w].nodes);
        const double s = feet.stop(topology, w, xOld, nodes, i, line.along(nodes.x[i]));
        if ((s < 0 || s > line.length) && !isConcaveEnd(topology, nodes.x, w, s > 0))
            nodes.wall[i] = -1;
        else
            land(line, w, s, topology, nodes, i);  // also removes the round-off
    }
    std::vector<std::pair<int, std::array<Line, 2>>> walls;  // now and before
    for (int w = 0; w < static_cast<int>(topology.walls.size()); ++w)
        if (topology.walls[w].patch >= 0)
            walls.push_back({w, {Line(nodes.x, topology.walls[w].nodes), Line(xOld, topology.walls[w].nodes)}});
    forEach(nodes.size(), [&](int i) {  // walls have their corners, which do not land
        if (topology.held(i) || topology.onWall[i] || nodes.wall[i] >= 0) return;
        const bool drop = topology.isolated(i);
        Landing first;
        const std::array<Line, 2>* line = nullptr;
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

template <>
void releaseFromWalls<2>(const RemeshingControls& controls, const Topology<2>& topology, const Vec<2>& gravity,
                         const ViscousFluid& fluid, double dt, Nodes<2>& nodes) {
    for (int i = 0; i < nodes.size(); ++i) {
        if (nodes.wall[i] < 0 || topology.corner[i]) continue;
        const Face<2>& face = topology.walls[nodes.wall[i]].nodes;
        const Line line(nodes.x, face);
        const Vec<2> slip = nodes.v[i] - line.between(line.along(nodes.x[i]), nodes.v, face);
        const double rate = slip.norm() / nodes.h[i];
        const double scale = fluid.rho * (gravity.norm() * nodes.h[i] + 0.5 * slip.squaredNorm() +
                                          unseenPart * std::pow(nodes.h[i] / dt, 2)) +
                             viscosity(fluid, rate) * rate;
        const bool pulledOff =  // the wall's acceleration is the normal part of a
            topology.isolated(i) && (gravity - nodes.a[i]).dot(line.inward) > 1e-9 * gravity.norm();
        if (!pulledOff && !(topology.freeSurface[i] && -nodes.p[i] > controls.wallTension * scale)) continue;
        nodes.wall[i] = -1;
        nodes.p[i] = 0;
        nodes.x[i] += 1e-3 * nodes.h[i] * line.inward;
    }
}

}  // namespace pfem
