#include "mesh/wallScreen.hpp"

#include <algorithm>
#include <tuple>

#include "mesh/components.hpp"
#include "mesh/distance.hpp"

namespace pfem {

namespace {

constexpr double sealed = 0.1;     // of the detour: a wall that is nearer to the end of another one closes it
constexpr double outside = 0.125;  // of the detour: farther behind both faces of a convex edge a point is not beside it

/// Rigid, and none that lets water through; behind skins there are solids, which put out what comes in.
template <int Dim>
bool isRigid(const Topology<Dim>& topology, int wall) {
    return topology.walls[wall].patch >= 0 && !topology.isOpening(wall) && !topology.isSkin(wall);
}

/// The rigid walls with a free end somewhere, they or those with which they are joined point by point: nothing comes
/// round a closed surface.
template <int Dim>
std::vector<unsigned char> wallsWithEnds(const Topology<Dim>& topology, std::size_t nPoints) {
    std::vector<Face<Dim>> faces;
    for (const auto& wall : topology.walls) faces.push_back(wall.nodes);
    const auto body = components(faces, static_cast<int>(nPoints));
    std::vector<unsigned char> ends(nPoints, 0), result(faces.size(), 0);
    for (const auto& wall : topology.walls)
        for (const Bend bend : wall.bend)
            if (wall.patch >= 0 && bend == Bend::open) ends[body[wall.nodes[0]]] = 1;
    for (std::size_t w = 0; w < faces.size(); ++w)
        result[w] = isRigid<Dim>(topology, static_cast<int>(w)) && ends[body[faces[w][0]]];
    return result;
}

}  // namespace

template <int Dim>
WallScreen<Dim>::WallScreen(const Topology<Dim>& topology, const Points<Dim>& x)
    : topology_(topology), x_(x), places_(topology.walls, x), hasEnd_(wallsWithEnds<Dim>(topology, x.size())) {}

template <int Dim>
bool WallScreen<Dim>::mayHide(int wall) const {
    return hasEnd_[wall] != 0;
}

template <int Dim>
bool WallScreen<Dim>::holds(int wall, const HeldPoint<Dim>& point) const {
    return isOnRegion<Dim>(topology_.walls, point.walls, topology_.walls[wall].region);
}

/// How far the point is before the wall [m], before its face or the curve that it stands for; 0 of one that it holds.
template <int Dim>
double WallScreen<Dim>::distanceBefore(int w, const HeldPoint<Dim>& point) const {
    if (holds(w, point)) return 0;
    const auto& wall = topology_.walls[w];
    const double flat = inwardNormal<Dim>(x_, wall.nodes).dot(point.x - x_[wall.nodes[0]]);
    if (!wall.bent) return flat;
    const auto place = placeOnRegion<Dim>(topology_.walls, x_, w, point.x);
    return std::max(flat, place.normal.dot(point.x - place.x));
}

template <int Dim>
bool WallScreen<Dim>::hides(const HeldPoint<Dim>& point, double reach) const {
    bool hidden = false;
    places_.forEachNear(point.x, point.x, reach, [&](int w) {
        const auto& face = topology_.walls[w].nodes;
        hidden = hidden || (inwardNormal<Dim>(x_, face).dot(point.x - x_[face[0]]) < 0 && mayHide(w) &&
                            distanceToFace<Dim>(x_, face, point.x) < reach && distanceBefore(w, point) < 0);
    });
    return hidden;
}

template <int Dim>
std::optional<WallPlace<Dim>> WallScreen<Dim>::backAt(const HeldPoint<Dim>& point, double reach, double detour) const {
    int nearest = -1;
    double behind = reach, before = reach;
    places_.forEachNear(point.x, point.x, reach, [&](int w) {
        const double distance = mayHide(w) ? distanceToFace<Dim>(x_, topology_.walls[w].nodes, point.x) : reach;
        if (distance >= reach) return;
        if (distanceBefore(w, point) >= 0) {
            before = std::min(before, distance);
        } else if (distance < behind || (distance == behind && w < nearest)) {  // of two the first
            behind = distance;
            nearest = w;
        }
    });
    if (nearest < 0 || before < (1 + 1e-9) * behind) return std::nullopt;  // the front of another one is nearer
    const auto place = placeOnRegion<Dim>(topology_.walls, x_, nearest, point.x);
    if (place.beyond >= 0 || isRound(nearest, place.x, point, detour)) return std::nullopt;
    return place;
}

/// Does another wall pass the point?
template <int Dim>
bool WallScreen<Dim>::isClosedAt(int wall, const Vec<Dim>& point, double near) const {
    bool found = false;
    places_.forEachNear(point, point, near, [&](int w) {
        found =
            found || (!topology_.joined(w, wall) && distanceToFace<Dim>(x_, topology_.walls[w].nodes, point) < near);
    });
    return found;
}

/// Is the edge of face w opposite to node k an end round which there is a way to a point? No free one along another
/// wall, as that of a gate on the floor (it may end there, as a lip at the side of a flume), nor a convex one beside
/// which the point is outside.
template <int Dim>
bool WallScreen<Dim>::isPassable(int w, int k, const Vec<Dim>& end, const HeldPoint<Dim>& to, double detour) const {
    const auto& [nodes, bend] = std::tie(topology_.walls[w].nodes, topology_.walls[w].bend);
    if (bend[k] == Bend::convex)
        return std::max(distanceBefore(w, to), distanceBefore(topology_.walls[w].next[k], to)) > -outside * detour;
    if (bend[k] != Bend::open) return false;
    const Vec<Dim>&c = x_[nodes[(k + 1) % Dim]], &d = x_[nodes[(k + Dim - 1) % Dim]];
    const Vec<Dim> along = (c - end).squaredNorm() > (d - end).squaredNorm() ? Vec<Dim>(c - end) : Vec<Dim>(d - end);
    const double length = along.norm();
    const Vec<Dim> further = length > 0 ? Vec<Dim>(end + std::min(1.0, detour / length) * along) : end;
    return !isClosedAt(w, end, sealed * detour) || !isClosedAt(w, further, sealed * detour);
}

/// Is the way round a free end or a convex edge of the wall nearly as short as the straight one?
template <int Dim>
bool WallScreen<Dim>::isRound(int wall, const Vec<Dim>& from, const HeldPoint<Dim>& to, double detour) const {
    bool found = false;
    const Vec<Dim> middle = 0.5 * (from + to.x);
    const double straight = (to.x - from).norm();
    places_.forEachNear(from.cwiseMin(to.x), from.cwiseMax(to.x), detour, [&](int w) {
        if (found || !topology_.joined(w, wall)) return;
        const auto& nodes = topology_.walls[w].nodes;
        for (int k = 0; !found && k < Dim; ++k) {
            const Vec<Dim>&c = x_[nodes[(k + 1) % Dim]], &d = x_[nodes[(k + Dim - 1) % Dim]];  // in the plane one point
            const Vec<Dim> end = c + nearestWeight<Dim>(c, d, middle) * (d - c);
            found = (end - from).norm() + (to.x - end).norm() < straight + detour && isPassable(w, k, end, to, detour);
        }
    });
    return found;
}

template <int Dim>
bool WallScreen<Dim>::parts(const HeldPoint<Dim>& from, const HeldPoint<Dim>& to, double slack, double detour) const {
    bool parted = false;
    places_.forEachNear(from.x.cwiseMin(to.x), from.x.cwiseMax(to.x), slack, [&](int w) {
        if (parted || !mayHide(w)) return;
        const double before = distanceBefore(w, from), after = distanceBefore(w, to);
        if (!((before > slack || holds(w, from)) && after < -slack)) return;
        const double part = std::max(0.0, before / (before - after));  // on the wall: it begins there
        const Vec<Dim> cut = from.x + part * (to.x - from.x);
        parted = footWeights<Dim>(x_, topology_.walls[w].nodes, cut).minCoeff() > -1e-9 && !isRound(w, cut, to, detour);
    });
    return parted;
}

template class WallScreen<2>;
template class WallScreen<3>;

}  // namespace pfem
