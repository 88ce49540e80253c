#include "walls/landing.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"
#include "conditions/wallFreedom.hpp"
#include "mesh/onFace.hpp"
#include "state/calm.hpp"
#include "walls/arrival.hpp"
#include "walls/meeting.hpp"

namespace pfem {

namespace {

constexpr double roundOff = 1e-6;  // of h, where faces meet
constexpr double meets = 1e-3;     // of h, how far from a meeting of walls one of them may end
constexpr double apart = 0.05;     // of h, before a corner that another node has

template <int Dim>
class Lander {
public:
    Lander(const Topology<Dim>& topology, double gravity, Nodes<Dim>& nodes)
        : topology_(topology), gravity_(gravity), nodes_(nodes) {}

    /// Those who slide.
    void stay() {
        for (int i = 0; i < nodes_.size(); ++i)  // those who stay have the corners
            if (isHeld(i) && nSupports(nodes_.wall[i]) == Dim) {
                if (isAtOpening(i))
                    corners_.push_back(nodes_.x[i]);
                else
                    stayInCorner(i);
            }
        for (int i = 0; i < nodes_.size(); ++i)
            if (isHeld(i) && nSupports(nodes_.wall[i]) < Dim && !isAtOpening(i)) stayOnWalls(i);
    }

    /// Those who arrive.
    void land(const Arrivals<Dim>& arrivals, const Points<Dim>& xOld) {
        const auto isNoOpening = [this](int wall) { return !topology_.isOpening(wall); };
        std::vector<Arrival> first(nodes_.size());
        parallelFor(nodes_.size(), [&](int i) {
            if (topology_.ofFluid(i) && nSupports(nodes_.wall[i]) < Dim && !isAtOpening(i))
                first[i] = arrivals.first(i, isNoOpening);
        });
        for (int i = 0; i < nodes_.size(); ++i) {
            Arrival arrival = first[i];
            for (int turn = 0; turn < Dim && arrival.any(); ++turn) {  // into an edge, or a corner
                if (arrival.part < 1) nodes_.x[i] = xOld[i] + arrival.part * (nodes_.x[i] - xOld[i]);
                addWall(i, arrival.wall);
                arrival = arrivals.first(i, isNoOpening);
            }
        }
    }

private:
    /// Openings put their nodes back themselves (walls/openings.hpp).
    bool isAtOpening(int i) const {
        const auto& own = nodes_.wall[i];
        return std::any_of(own.begin(), own.end(), [&](int w) { return w >= 0 && topology_.isOpening(w); });
    }
    bool isHeld(int i) const { return topology_.ofFluid(i) && isSupported(nodes_.wall[i]); }

    WallPlace<Dim> placeOn(int wall, const Vec<Dim>& point) const {
        return placeOnRegion<Dim>(topology_.walls, nodes_.x, wall, point);
    }
    int regionOf(int wall) const { return topology_.walls[wall].region; }

    /// The wall of this region holds node i no longer.
    void dropRegion(int i, int region) {
        for (const int wall : Supports<Dim>(nodes_.wall[i]))
            if (wall >= 0 && regionOf(wall) == region) dropSupport(nodes_.wall[i], wall);
    }

    /// Put node i where its walls meet. Do they?
    bool settle(int i) {
        const auto meeting =
            meetingOf<Dim>(topology_.walls, nodes_.x, nodes_.wall[i], nodes_.x[i], meets * nodes_.h[i]);
        if (!meeting) return false;
        nodes_.x[i] = meeting->x;
        nodes_.wall[i] = meeting->walls;
        return true;
    }

    /// A moving wall has left the others: the node goes on along those that are nearer.
    void settleOnNearest(int i) {
        while (!settle(i)) {
            int farthest = -1;
            double most = -1;
            for (const int wall : nodes_.wall[i]) {
                if (wall < 0) continue;
                const double distance = (placeOn(wall, nodes_.x[i]).x - nodes_.x[i]).norm();
                if (distance > most) farthest = wall, most = distance;
            }
            dropSupport(nodes_.wall[i], farthest);
        }
    }

    void stayInCorner(int i) {
        settleOnNearest(i);
        letGoRound(i);
        if (nSupports(nodes_.wall[i]) == Dim) corners_.push_back(nodes_.x[i]);
    }

    /// How the water around node i moves relative to it: the sum of the neighbours' velocities; no number where all
    /// are slow.
    std::optional<Vec<Dim>> flowAround(int i) const {
        Vec<Dim> flow = Vec<Dim>::Zero();
        double fastest = 0;
        for (int s = topology_.ring.start[i]; s < topology_.ring.start[i + 1]; ++s) {
            const Vec<Dim> u = nodes_.v[topology_.ring.node[s]] - nodes_.v[i];
            flow += u;
            fastest = std::max(fastest, u.squaredNorm());
        }
        return fastest > calmSpeedSquared(gravity_, nodes_.h[i]) ? std::optional<Vec<Dim>>(flow) : std::nullopt;
    }

    /// Water that moves takes a node along, round a convex edge: of its two walls it keeps the one along which the
    /// water flows.
    void letGoRound(int i) {
        const Supports<Dim> walls = nodes_.wall[i];
        for (int k = 1; k < nSupports(walls); ++k)
            for (int l = 0; l < k; ++l) {
                if (!topology_.joined(walls[k], walls[l])) continue;
                const auto flow = flowAround(i);
                if (!flow) return;
                const Vec<Dim> n = placeOn(walls[l], nodes_.x[i]).normal, m = placeOn(walls[k], nodes_.x[i]).normal;
                const double c = n.dot(m);  // away from the edge: along the first wall c n - m, along the other c m - n
                dropRegion(i, regionOf(walls[flow->dot(c * n - m) >= flow->dot(c * m - n) ? k : l]));
            }
    }

    /// Back onto its walls; what their ends do with it.
    void stayOnWalls(int i) {
        letGoRound(i);
        const Supports<Dim> before = nodes_.wall[i];
        for (const int wall : before) {
            if (wall < 0) continue;
            const auto place = placeOn(wall, nodes_.x[i]);
            if (place.beyond >= 0) leaveEnd(i, place);
        }
        if (isSupported(nodes_.wall[i])) settleOnNearest(i);
    }

    /// Node i has come beyond the end of a wall.
    void leaveEnd(int i, const WallPlace<Dim>& place) {
        const auto& face = topology_.walls[place.face];
        const int next = face.next[place.beyond];
        const bool isBeyond = (place.x - nodes_.x[i]).norm() > roundOff * nodes_.h[i];
        switch (face.bend[place.beyond]) {
            case Bend::concave:
                if (next >= 0)
                    addWall(i, next);
                else
                    stopAtFork(i, place);
                break;
            case Bend::convex:
                if (isBeyond) goRound(i, face.region, next);
                break;
            case Bend::open:
                if (isBeyond && !isStopped(i, place)) dropRegion(i, face.region);
                break;
            case Bend::smooth:
                break;
        }
    }

    /// Beyond a convex edge: along the next wall under water, free at the surface.
    void goRound(int i, int region, int next) {
        dropRegion(i, region);
        if (topology_.freeSurface[i] || topology_.isolated(i)) return;
        if (!isOnRegion<Dim>(topology_.walls, nodes_.wall[i], regionOf(next))) addSupport(nodes_.wall[i], next);
        settleOnNearest(i);
        keepVelocity(i);
    }

    /// Where three walls and more meet at an edge, a little before it.
    void stopAtFork(int i, const WallPlace<Dim>& place) {
        const Vec<Dim> back = nodes_.x[topology_.walls[place.face].nodes[place.beyond]] - place.x;
        nodes_.x[i] = place.x + back * std::min(apart * nodes_.h[i] / back.norm(), 0.5);
    }

    /// Does a solid stand where the wall ends?
    bool isStopped(int i, const WallPlace<Dim>& place) const {
        for (int j = 0; j < nodes_.size(); ++j)
            if (topology_.onSolid[j] && topology_.supportOn(j, place.face) >= 0 &&
                (nodes_.x[j] - place.x).norm() < 0.01 * nodes_.h[i])
                return true;
        return false;
    }

    bool isTaken(const Vec<Dim>& corner, double near) const {
        return std::any_of(corners_.begin(), corners_.end(),
                           [&](const Vec<Dim>& x) { return (x - corner).norm() < near; });
    }

    /// One more wall holds the node; not where they do not meet or another one has the corner.
    void addWall(int i, int wall) {
        if (isHeldBy<Dim>(topology_, nodes_.wall[i], wall) || nSupports(nodes_.wall[i]) == Dim) return;
        const Supports<Dim> own = nodes_.wall[i];
        const Vec<Dim> x = nodes_.x[i];
        addSupport(nodes_.wall[i], wall);
        const bool met = settle(i), corner = nSupports(nodes_.wall[i]) == Dim;
        if (met && !(corner && isTaken(nodes_.x[i], meets * nodes_.h[i]))) {
            if (corner) corners_.push_back(nodes_.x[i]);
            keepVelocity(i);
            return;
        }
        nodes_.wall[i] = own;
        nodes_.x[i] = x;
        stopBefore(i, wall);
    }

    /// Not behind the wall, but a little before it, along those that hold the node: node control is going to take it
    /// out.
    void stopBefore(int i, int wall) {
        const auto place = placeOn(wall, nodes_.x[i]);
        const double distance = place.normal.dot(nodes_.x[i] - place.x);
        if (distance > roundOff * nodes_.h[i]) return;
        const Vec<Dim> along = freedomOn<Dim>(topology_.walls, nodes_.x, nodes_.wall[i]).project(place.normal);
        if (along.norm() > 1e-3) nodes_.x[i] += along * ((apart * nodes_.h[i] - distance) / along.dot(place.normal));
    }

    /// Velocity and acceleration normal to the node's walls are those of the walls. Solids get its momentum in the next
    /// step.
    void keepVelocity(int i) {
        for (auto* values : {&nodes_.v, &nodes_.a}) {
            Freedom<Dim> free;
            for (const int wall : nodes_.wall[i]) {
                if (wall < 0 || topology_.isSkin(wall)) continue;
                const Face<Dim>& face = topology_.walls[wall].nodes;
                const Vec<Dim> n = inwardNormal<Dim>(nodes_.x, face), part = free.project(n);
                if (part.norm() < 1e-6) continue;
                const double missing = n.dot(onFace<Dim>(nodes_.x, face, nodes_.x[i], *values) - (*values)[i]);
                (*values)[i] += part * (missing / part.squaredNorm());
                free = free.without(n);
            }
        }
    }

    const Topology<Dim>& topology_;
    double gravity_;
    Nodes<Dim>& nodes_;
    std::vector<Vec<Dim>> corners_;  // where there is a node
};

}  // namespace

template <int Dim>
void landOnWalls(const WallDistances& controls, const Topology<Dim>& topology, const Points<Dim>& xOld, double gravity,
                 State<Dim>& state) {
    Lander<Dim> lander(topology, gravity, state.nodes);
    lander.stay();
    lander.land({controls.landingDistance, topology, xOld, state.nodes}, xOld);
}

#define PFEM_INSTANTIATE(D) \
    template void landOnWalls<D>(const WallDistances&, const Topology<D>&, const Points<D>&, double, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
