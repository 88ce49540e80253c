#include "walls/landing.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "base/parallel.hpp"
#include "state/calm.hpp"
#include "walls/meeting.hpp"
#include "walls/wallLine.hpp"

namespace pfem {

namespace {

constexpr double roundOff = 1e-6;  // of h, where faces meet

/// Where a node lands on a wall, how far from its start and after which part of its way.
struct Landing {
    double part = std::numeric_limits<double>::max();  // it does not
    double place = 0;
    int wall = -1;
};

using Lines = std::array<WallLine, 2>;  // of a wall face now and before

/// The landing of a node on its way from xOld to x on a wall: it has crossed the wall or is within distance h of it.
/// What is part of the fluid is put on the wall where it is; a drop, whose way may be many h long, where it has crossed
/// it.
Landing landingOn(const Lines& line, const Vec<2>& xOld, const Vec<2>& x, double h, double distance, bool drop) {
    const double after = line[0].distance(x), before = line[1].distance(xOld);
    if (after > distance * h || before < -1e-9 * h || after >= before) return {};  // far, was behind, or leaves
    Landing landing;
    landing.part = drop && after < 0 ? std::max(0.0, before / (before - after)) : 1;
    landing.place = line[0].along(x);
    if (landing.part < 1) landing.place = line[1].along(xOld) + landing.part * (landing.place - line[1].along(xOld));
    const bool within = landing.place >= -roundOff * h && landing.place <= line[0].length + roundOff * h;
    return within ? landing : Landing{};
}

class Lander {
public:
    Lander(const WallDistances& controls, const Topology<2>& topology, const Points<2>& xOld, double gravity,
           Nodes<2>& nodes)
        : controls_(controls), topology_(topology), xOld_(xOld), gravity_(gravity), nodes_(nodes) {}

    void run() {
        for (int i = 0; i < nodes_.size(); ++i)  // those who stay have the corners
            if (isHeld(i) && nSupports(nodes_.wall[i]) == 2) stayInCorner(i);
        for (int i = 0; i < nodes_.size(); ++i)
            if (isHeld(i) && nSupports(nodes_.wall[i]) == 1) stayOnWall(i);
        landOthers();
    }

private:
    bool isHeld(int i) const { return topology_.ofFluid(i) && isSupported(nodes_.wall[i]); }
    WallLine lineOf(int wall) const { return {nodes_.x, topology_.walls[wall].nodes}; }
    static std::pair<int, int> cornerOf(int wall, int other) { return std::minmax(wall, other); }

    /// Put node i into the corner of both walls, if there is one and nobody in it. Its velocity is theirs.
    bool enterCorner(int i, int wall, int other) {
        const auto place = meetingOf(topology_, nodes_.x, wall, other, roundOff * nodes_.h[i]);
        if (!place || !corners_.insert(cornerOf(wall, other)).second) return false;
        nodes_.x[i] = *place;
        nodes_.wall[i] = {wall, other};
        const WallLine a = lineOf(wall), b = lineOf(other);
        for (auto* values : {&nodes_.v, &nodes_.a}) {  // n_k . u = n_k . u_k
            const Vec<2> ofA = a.between(a.along(*place), *values, topology_.walls[wall].nodes),
                         ofB = b.between(b.along(*place), *values, topology_.walls[other].nodes);
            const double na = a.inward.dot(ofA), nb = b.inward.dot(ofB), det = a.inward.dot(b.tangent);
            (*values)[i] = (na * b.tangent - nb * a.tangent) / det;
        }
        return true;
    }

    void stayInCorner(int i) {
        const auto [wall, other] = nodes_.wall[i];
        const auto place = meetingOf(topology_, nodes_.x, wall, other, roundOff * nodes_.h[i]);
        if (!place) {  // a moving wall has left the other one: the nearer one has its water
            const Vec<2>& x = nodes_.x[i];
            const auto off = [&](int w) {
                return (placeOnRegion<2>(topology_.walls, nodes_.x, w, x).x - x).squaredNorm();
            };
            dropSupport(nodes_.wall[i], off(wall) <= off(other) ? other : wall);
            return;
        }
        nodes_.x[i] = *place;
        if (isConvexEnd(topology_, wall, other) && letGoRound(i)) return;
        corners_.insert(cornerOf(wall, other));
    }

    /// Water that moves takes the node along, round a convex corner: it keeps the wall along which the water flows.
    bool letGoRound(int i) {
        Vec<2> flow = Vec<2>::Zero();
        double fastest = 0;
        for (int s = topology_.ring.start[i]; s < topology_.ring.start[i + 1]; ++s) {
            const Vec<2> u = nodes_.v[topology_.ring.node[s]] - nodes_.v[i];
            flow += u;
            fastest = std::max(fastest, u.squaredNorm());
        }
        if (fastest <= calmSpeedSquared(gravity_, nodes_.h[i])) return false;
        const auto away = [&](int wall) {  // from the corner along the wall
            const WallLine line = lineOf(wall);
            return Vec<2>(line.along(nodes_.x[i]) > 0.5 * line.length ? -line.tangent : line.tangent);
        };
        const auto [wall, other] = nodes_.wall[i];
        dropSupport(nodes_.wall[i], flow.dot(away(wall)) >= flow.dot(away(other)) ? other : wall);
        return true;
    }

    void stayOnWall(int i) {
        const int wall = nodes_.wall[i][0];
        const auto place = placeOnRegion<2>(topology_.walls, nodes_.x, wall, nodes_.x[i]);
        nodes_.wall[i] = {place.face, -1};
        const bool ends = place.beyond >= 0;
        const Bend bend = ends ? topology_.walls[place.face].bend[place.beyond] : Bend::smooth;
        const int next = ends ? topology_.walls[place.face].next[place.beyond] : -1;
        if (bend == Bend::open && !isStopped(i, place)) {
            nodes_.wall[i] = unsupported<2>();
            return;
        }
        if (bend == Bend::convex) {
            goRound(i, next);
            return;
        }
        nodes_.x[i] = place.x;
        if (bend == Bend::concave && !(next >= 0 && enterCorner(i, place.face, next)))
            stopBefore(i, place.face, place.x);
    }

    /// Beyond a convex corner: along the next wall under water, free at the surface.
    void goRound(int i, int next) {
        nodes_.wall[i] = unsupported<2>();
        if (topology_.freeSurface[i] || topology_.isolated(i)) return;
        const auto place = placeOnRegion<2>(topology_.walls, nodes_.x, next, nodes_.x[i]);
        land(lineOf(place.face), place.face, lineOf(place.face).along(place.x), i);
    }

    /// Does a solid stand where the wall ends?
    bool isStopped(int i, const WallPlace<2>& place) const {
        for (int j = 0; j < nodes_.size(); ++j)
            if (topology_.onSolid[j] && topology_.supportOn(j, place.face) >= 0 &&
                (nodes_.x[j] - place.x).norm() < 0.01 * nodes_.h[i])
                return true;
        return false;
    }

    /// A little before the corner that somebody else has: node control is going to take it out.
    void stopBefore(int i, int wall, const Vec<2>& corner) {
        const WallLine line = lineOf(wall);
        const double s = line.along(corner), room = std::min(0.05 * nodes_.h[i], 0.5 * line.length);
        nodes_.x[i] = line.start + (s > 0.5 * line.length ? line.length - room : room) * line.tangent;
    }

    /// Put node i on the wall face w at distance s from its start; there it moves along with the wall.
    void land(const WallLine& line, int w, double s, int i) {
        const Face<2>& face = topology_.walls[w].nodes;
        s = std::clamp(s, 0.0, line.length);
        const auto alongWith = [&](const Vec<2>& own, const Vec<2>& ofWall) -> Vec<2> {
            const Vec<2> along = line.tangent * line.tangent.dot(own);
            const double normal = line.inward.dot(ofWall);
            return normal == 0 ? along : Vec<2>(along + normal * line.inward);
        };
        nodes_.x[i] = line.start + s * line.tangent;
        nodes_.v[i] = alongWith(nodes_.v[i], line.between(s, nodes_.v, face));
        nodes_.a[i] = alongWith(nodes_.a[i], line.between(s, nodes_.a, face));
        nodes_.wall[i] = {w, -1};
    }

    void landOthers() {
        std::vector<std::pair<int, Lines>> walls;
        for (int w = 0; w < static_cast<int>(topology_.walls.size()); ++w) {
            const auto& face = topology_.walls[w];
            if (face.patch >= 0) walls.push_back({w, {WallLine(nodes_.x, face.nodes), WallLine(xOld_, face.nodes)}});
        }
        std::vector<Landing> landings(nodes_.size());
        parallelFor(nodes_.size(), [&](int i) {
            if (!topology_.ofFluid(i) || nSupports(nodes_.wall[i]) == 2) return;
            const int own = nodes_.wall[i][0];
            const bool drop = topology_.isolated(i);
            for (const auto& [w, lines] : walls) {
                if (own >= 0 && topology_.joined(own, w)) continue;
                Landing landing = landingOn(lines, xOld_[i], nodes_.x[i], nodes_.h[i], controls_.landingDistance, drop);
                if (landing.part >= landings[i].part) continue;
                landing.wall = w;
                landings[i] = landing;
            }
        });
        for (int i = 0; i < nodes_.size(); ++i) {
            const Landing& landing = landings[i];
            if (landing.wall < 0) continue;
            const WallLine line = lineOf(landing.wall);
            const int own = nodes_.wall[i][0];
            if (own < 0) {
                land(line, landing.wall, landing.place, i);
                nodes_.x[i] = placeOnRegion<2>(topology_.walls, nodes_.x, landing.wall, nodes_.x[i]).x;
            } else if (!enterCorner(i, own, landing.wall) && line.distance(nodes_.x[i]) < 0)
                nodes_.x[i] += (0.05 * nodes_.h[i] - line.distance(nodes_.x[i])) * line.inward;
        }
    }

    const WallDistances& controls_;
    const Topology<2>& topology_;
    const Points<2>& xOld_;
    double gravity_;
    Nodes<2>& nodes_;
    std::set<std::pair<int, int>> corners_;  // where there is a node, by their walls
};

}  // namespace

template <>
void landOnWalls<2>(const WallDistances& controls, const Topology<2>& topology, const Points<2>& xOld, double gravity,
                    State<2>& state) {
    Lander(controls, topology, xOld, gravity, state.nodes).run();
}

}  // namespace pfem
