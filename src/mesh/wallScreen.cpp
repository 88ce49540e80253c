#include "mesh/wallScreen.hpp"

#include <tuple>

#include "mesh/distance.hpp"

namespace pfem {

namespace {

constexpr double sealed = 0.1;  // of the detour: what is nearer to the end of a wall closes it

}  // namespace

template <int Dim>
WallScreen<Dim>::WallScreen(const Topology<Dim>& topology, const Points<Dim>& x)
    : topology_(topology), x_(x), places_(topology.walls, x) {}

/// Behind skins there are solids, which put out what comes in.
template <int Dim>
bool WallScreen<Dim>::isClosed(int wall) const {
    return topology_.walls[wall].patch >= 0 && !topology_.isOpening(wall) && !topology_.isSkin(wall);
}

/// How far the point is before the wall [m]; 0 of one that the wall holds.
template <int Dim>
double WallScreen<Dim>::distanceBefore(int w, const HeldPoint<Dim>& point) const {
    if (isOnRegion<Dim>(topology_.walls, point.walls, topology_.walls[w].region)) return 0;
    const auto& wall = topology_.walls[w];
    if (!wall.bent) return inwardNormal<Dim>(x_, wall.nodes).dot(point.x - x_[wall.nodes[0]]);
    const auto place = placeOnRegion<Dim>(topology_.walls, x_, w, point.x);  // it bulges out of its faces
    return place.normal.dot(point.x - place.x);
}

template <int Dim>
bool WallScreen<Dim>::hides(const HeldPoint<Dim>& point, double reach) const {
    bool hidden = false;
    places_.forEachNear(point.x, point.x, reach, [&](int w) {
        const auto& face = topology_.walls[w].nodes;
        hidden = hidden || (inwardNormal<Dim>(x_, face).dot(point.x - x_[face[0]]) < 0 && isClosed(w) &&
                            distanceToFace<Dim>(x_, face, point.x) < reach && distanceBefore(w, point) < 0);
    });
    return hidden;
}

template <int Dim>
std::optional<WallPlace<Dim>> WallScreen<Dim>::backAt(const HeldPoint<Dim>& point, double reach, double detour) const {
    int nearest = -1;
    double least = reach;
    places_.forEachNear(point.x, point.x, reach, [&](int w) {
        const double distance = isClosed(w) ? distanceToFace<Dim>(x_, topology_.walls[w].nodes, point.x) : reach;
        if (distance > least || (distance == least && (nearest < 0 || w > nearest))) return;  // of two the first
        least = distance;
        nearest = w;
    });
    if (nearest < 0 || !(distanceBefore(nearest, point) < 0)) return std::nullopt;
    const auto place = placeOnRegion<Dim>(topology_.walls, x_, nearest, point.x);
    if (place.beyond >= 0 || isRound(nearest, place.x, point.x, detour)) return std::nullopt;
    return place;
}

/// Does another wall pass the end of this one?
template <int Dim>
bool WallScreen<Dim>::isSealed(int wall, const Vec<Dim>& end, double near) const {
    bool found = false;
    places_.forEachNear(end, end, near, [&](int w) {
        found = found || (!topology_.joined(w, wall) && distanceToFace<Dim>(x_, topology_.walls[w].nodes, end) < near);
    });
    return found;
}

/// Is the way round a free end or a convex edge of the wall nearly as short as the straight one?
template <int Dim>
bool WallScreen<Dim>::isRound(int wall, const Vec<Dim>& from, const Vec<Dim>& to, double detour) const {
    bool found = false;
    const Vec<Dim> middle = 0.5 * (from + to);
    const double straight = (to - from).norm();
    places_.forEachNear(from.cwiseMin(to), from.cwiseMax(to), detour, [&](int w) {
        if (found || !topology_.joined(w, wall)) return;
        const auto& [nodes, bend] = std::tie(topology_.walls[w].nodes, topology_.walls[w].bend);
        for (int k = 0; !found && k < Dim; ++k) {
            if (bend[k] != Bend::open && bend[k] != Bend::convex) continue;
            const Vec<Dim>&c = x_[nodes[(k + 1) % Dim]], &d = x_[nodes[(k + Dim - 1) % Dim]];  // in the plane one point
            const Vec<Dim> end = c + nearestWeight<Dim>(c, d, middle) * (d - c);
            found = (end - from).norm() + (to - end).norm() < straight + detour &&
                    !(bend[k] == Bend::open && isSealed(wall, end, sealed * detour));
        }
    });
    return found;
}

template <int Dim>
bool WallScreen<Dim>::parts(const HeldPoint<Dim>& from, const HeldPoint<Dim>& to, double slack, double detour) const {
    bool parted = false;
    places_.forEachNear(from.x.cwiseMin(to.x), from.x.cwiseMax(to.x), slack, [&](int w) {
        if (parted || !isClosed(w)) return;
        const double before = distanceBefore(w, from), after = distanceBefore(w, to);
        if (!(before > -slack && after < -slack)) return;
        const double part = std::max(0.0, before / (before - after));  // on the wall: it begins there
        const Vec<Dim> cut = from.x + part * (to.x - from.x);
        parted =
            footWeights<Dim>(x_, topology_.walls[w].nodes, cut).minCoeff() > -1e-9 && !isRound(w, cut, to.x, detour);
    });
    return parted;
}

template class WallScreen<2>;
template class WallScreen<3>;

}  // namespace pfem
