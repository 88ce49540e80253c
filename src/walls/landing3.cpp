#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <set>

#include "base/parallel.hpp"
#include "conditions/freedom.hpp"
#include "mesh/onFace.hpp"
#include "walls/landing.hpp"

namespace pfem {

namespace {

constexpr double roundOff = 1e-6;  // of h, where faces meet
constexpr double apart = 0.05;     // of h, before a corner that another node has

/// Where a node comes to a wall, and after which part of its way.
struct Landing {
    double part = std::numeric_limits<double>::max();  // it does not
    int wall = -1;
};

class Lander {
public:
    Lander(const WallDistances& controls, const Topology<3>& topology, const Points<3>& xOld, Nodes<3>& nodes)
        : controls_(controls), topology_(topology), xOld_(xOld), nodes_(nodes) {}

    void run() {
        for (int i = 0; i < nodes_.size(); ++i)  // those who stay have the corners
            if (isHeld(i) && nSupports(nodes_.wall[i]) == 3) corners_.insert(cornerOf(nodes_.wall[i]));
        for (int i = 0; i < nodes_.size(); ++i)
            if (isHeld(i)) stay(i);
        landOthers();
    }

private:
    using Corner = std::array<int, 3>;

    bool isHeld(int i) const { return topology_.ofFluid(i) && isSupported(nodes_.wall[i]); }

    /// The regions of three walls.
    Corner cornerOf(const Supports<3>& walls) const {
        Corner corner{};
        for (int k = 0; k < 3; ++k) corner[k] = topology_.walls[walls[k]].region;
        std::sort(corner.begin(), corner.end());
        return corner;
    }

    WallPlace<3> placeOn(int wall, const Vec<3>& point) const {
        return placeOnRegion<3>(topology_.walls, nodes_.x, wall, point);
    }

    /// Put node i on all of its walls: the least displacement to where their planes meet.
    void settle(int i) {
        Supports<3>& walls = nodes_.wall[i];
        const int count = nSupports(walls);
        for (int turn = 0; turn < (count == 1 ? 1 : 4); ++turn) {
            Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> N(3, count);
            Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> off(count);
            for (int k = 0; k < count; ++k) {
                const auto place = placeOn(walls[k], nodes_.x[i]);
                walls[k] = place.face;
                if (count == 1) nodes_.x[i] = place.x;
                N.col(k) = place.normal;
                off[k] = place.normal.dot(place.x - nodes_.x[i]);
            }
            const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> metric = N.transpose() * N;
            if (count > 1) nodes_.x[i] += N * metric.inverse() * off;
        }
    }

    /// A node that slides: back onto its walls; what their ends do with it.
    void stay(int i) {
        for (const int wall : Supports<3>(nodes_.wall[i])) {
            if (wall < 0) continue;
            const auto place = placeOn(wall, nodes_.x[i]);
            if (place.beyond < 0 || (place.x - nodes_.x[i]).norm() <= roundOff * nodes_.h[i]) continue;
            const auto& face = topology_.walls[place.face];
            const int next = face.next[place.beyond];
            switch (face.bend[place.beyond]) {
                case Bend::concave:
                    if (next >= 0) addWall(i, next);
                    break;
                case Bend::convex:
                    dropSupport(nodes_.wall[i], wall);
                    if (!topology_.freeSurface[i] && !topology_.isolated(i)) addSupport(nodes_.wall[i], next);
                    break;
                case Bend::open:
                    dropSupport(nodes_.wall[i], wall);
                    break;
                case Bend::smooth:
                    break;
            }
        }
        if (isSupported(nodes_.wall[i])) settle(i);
    }

    bool isOn(int i, int wall) const {
        const auto& own = nodes_.wall[i];
        return std::any_of(own.begin(), own.end(), [&](int w) { return w >= 0 && topology_.joined(w, wall); });
    }

    /// One more wall holds the node; not where another one has the corner: it stays a little before it.
    void addWall(int i, int wall) {
        if (isOn(i, wall) || nSupports(nodes_.wall[i]) == 3) return;
        Supports<3> walls = nodes_.wall[i];
        addSupport(walls, wall);
        if (nSupports(walls) < 3 || corners_.insert(cornerOf(walls)).second) {
            nodes_.wall[i] = walls;
            settle(i);
            keepVelocity(i);
            return;
        }
        const auto place = placeOn(wall, nodes_.x[i]);
        Freedom<3> free;
        for (const int own : nodes_.wall[i])
            if (own >= 0) free = free.without(inwardNormal<3>(nodes_.x, topology_.walls[own].nodes));
        const Vec<3> along = free.project(place.normal);
        const double distance = place.normal.dot(nodes_.x[i] - place.x);
        if (distance < apart * nodes_.h[i] && along.norm() > 1e-3)
            nodes_.x[i] += along * ((apart * nodes_.h[i] - distance) / along.dot(place.normal));
    }

    /// Velocity and acceleration normal to the node's walls are those of the walls.
    void keepVelocity(int i) {
        for (auto* values : {&nodes_.v, &nodes_.a}) {
            Freedom<3> free;
            for (const int wall : nodes_.wall[i]) {
                if (wall < 0) continue;
                const Face<3>& face = topology_.walls[wall].nodes;
                const Vec<3> n = inwardNormal<3>(nodes_.x, face), part = free.project(n);
                if (part.norm() < 1e-6) continue;
                const double missing = n.dot(onFace<3>(nodes_.x, face, nodes_.x[i], *values) - (*values)[i]);
                (*values)[i] += part * (missing / part.squaredNorm());
                free = free.without(n);
            }
        }
    }

    /// Has the node crossed the wall's face, or is it within landingDistance h and comes nearer? A drop lands where it
    /// has crossed it.
    Landing landingOn(int i, int wall, bool drop) const {
        const Face<3>& face = topology_.walls[wall].nodes;
        const Vec<3>&x = nodes_.x[i], &old = xOld_[i];
        const double h = nodes_.h[i], after = inwardNormal<3>(nodes_.x, face).dot(x - nodes_.x[face[0]]),
                     before = inwardNormal<3>(xOld_, face).dot(old - xOld_[face[0]]);
        if (after > controls_.landingDistance * h || before < -1e-9 * h || after >= before) return {};
        const double part = after < 0 ? std::max(0.0, before / (before - after)) : 1;
        const double slack = roundOff * h / (nodes_.x[face[1]] - nodes_.x[face[0]]).norm();
        const bool crosses = part < 1 && footWeights<3>(xOld_, face, old + part * (x - old)).minCoeff() > -slack;
        const bool arrives = footWeights<3>(nodes_.x, face, x).minCoeff() > -slack;
        if (!crosses && !(arrives && !(drop && after < 0))) return {};
        return {crosses && drop ? part : 1, wall};
    }

    /// What the node comes to first, of the walls that do not hold it yet.
    Landing firstLanding(int i, bool drop) const {
        Landing first;
        for (int w = 0; w < static_cast<int>(topology_.walls.size()); ++w) {
            if (topology_.walls[w].patch < 0 || isOn(i, w)) continue;
            const Landing landing = landingOn(i, w, drop);
            if (landing.part < first.part) first = landing;
        }
        return first;
    }

    void landOthers() {
        std::vector<Landing> landings(nodes_.size());
        parallelFor(nodes_.size(), [&](int i) {
            if (!topology_.ofFluid(i) || nSupports(nodes_.wall[i]) == 3) return;
            landings[i] = firstLanding(i, topology_.isolated(i));
        });
        for (int i = 0; i < nodes_.size(); ++i) {
            const bool drop = topology_.isolated(i);
            for (int turn = 0; turn < 3 && landings[i].wall >= 0; ++turn) {  // into an edge, or a corner
                const auto [part, wall] = landings[i];
                if (part < 1) nodes_.x[i] = xOld_[i] + part * (nodes_.x[i] - xOld_[i]);
                addWall(i, wall);
                landings[i] = firstLanding(i, drop);
            }
        }
    }

    const WallDistances& controls_;
    const Topology<3>& topology_;
    const Points<3>& xOld_;
    Nodes<3>& nodes_;
    std::set<Corner> corners_;  // where there is a node
};

}  // namespace

template <>
void landOnWalls<3>(const WallDistances& controls, const Topology<3>& topology, const Points<3>& xOld, double,
                    State<3>& state) {
    Lander(controls, topology, xOld, state.nodes).run();
}

}  // namespace pfem
