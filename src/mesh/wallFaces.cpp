#include "mesh/wallFaces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "mesh/distance.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

template <int Dim>
using Edge = std::array<int, Dim - 1>;

/// The edge opposite to node k of a face (2D: its other end), sorted.
template <int Dim>
Edge<Dim> edgeOpposite(const Face<Dim>& face, int k) {
    Edge<Dim> edge{};
    for (int j = 1; j < Dim; ++j) edge[j - 1] = face[(k + j) % Dim];
    std::sort(edge.begin(), edge.end());
    return edge;
}

template <int Dim>
struct Side {
    Edge<Dim> edge;
    int face, node;  // the node opposite to the edge, local
};

/// How two faces join: by their normals, and by where the far node of the second is seen from the first.
template <int Dim>
Bend bendOf(const WallFace<Dim>& a, const WallFace<Dim>& b, int farNode, const Points<Dim>& x) {
    const Vec<Dim> n = inwardNormal<Dim>(x, a.nodes), m = inwardNormal<Dim>(x, b.nodes);
    if (n.dot(m) > std::cos(featureAngle * M_PI / 180)) return Bend::smooth;
    return n.dot(x[b.nodes[farNode]] - x[a.nodes[0]]) > 0 ? Bend::concave : Bend::convex;
}

int root(std::vector<int>& parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// Join the faces at one edge, whose sides begin at `first`.
template <int Dim>
void joinAt(const Side<Dim>* first, std::ptrdiff_t count, const Points<Dim>& x, std::vector<WallFace<Dim>>& walls,
            std::vector<int>& parent) {
    if (count == 1) return;
    for (std::ptrdiff_t k = 0; k < count; ++k)
        walls[first[k].face].bend[first[k].node] = Bend::concave;  // of three and more: a fork
    if (count > 2) return;
    for (const int k : {0, 1}) {
        const Side<Dim>&own = first[k], &other = first[1 - k];
        auto& face = walls[own.face];
        face.next[own.node] = other.face;
        face.bend[own.node] = bendOf<Dim>(face, walls[other.face], other.node, x);
        if (face.bend[own.node] != Bend::smooth) continue;
        const int a = root(parent, own.face), b = root(parent, other.face);
        parent[std::max(a, b)] = std::min(a, b);
    }
}

/// Join the faces of walls at their edges; `parent`: the regions that this makes.
template <int Dim>
void joinFaces(const Points<Dim>& x, std::vector<WallFace<Dim>>& walls, std::vector<int>& parent) {
    std::vector<Side<Dim>> sides;
    for (int w = 0; w < static_cast<int>(walls.size()); ++w)
        for (int node = 0; walls[w].patch >= 0 && node < Dim; ++node)
            sides.push_back({edgeOpposite<Dim>(walls[w].nodes, node), w, node});
    std::stable_sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.edge < b.edge; });
    for (auto first = sides.begin(); first != sides.end();) {
        const auto end = std::find_if(first, sides.end(), [&](const auto& side) { return side.edge != first->edge; });
        joinAt<Dim>(&*first, end - first, x, walls, parent);
        first = end;
    }
}

/// Normals at the points of each region: those of its faces, by their measures. At a tip, as that of a cone, from whose
/// mean normal the faces turn by more than featureAngle, there is none: each face has its own.
template <int Dim>
void setNormals(const Points<Dim>& x, std::vector<int>& parent, std::vector<WallFace<Dim>>& walls) {
    struct Corner {
        int region, point, face, node;  // node: local
    };
    std::vector<Corner> corners;
    for (int w = 0; w < static_cast<int>(walls.size()); ++w)
        for (int k = 0; walls[w].patch >= 0 && k < Dim; ++k)
            corners.push_back({root(parent, w), walls[w].nodes[k], w, k});
    std::stable_sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
        return std::pair(a.region, a.point) < std::pair(b.region, b.point);
    });
    for (auto first = corners.begin(); first != corners.end();) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        auto end = first;
        for (; end != corners.end() && end->region == first->region && end->point == first->point; ++end)
            sum -= faceArea<Dim>(x, walls[end->face].nodes);
        const Vec<Dim> mean = sum.normalized();
        const bool tip = std::any_of(first, end, [&](const Corner& corner) {
            return mean.dot(inwardNormal<Dim>(x, walls[corner.face].nodes)) < std::cos(featureAngle * M_PI / 180);
        });
        for (; first != end; ++first) {
            auto& face = walls[first->face];
            face.normal[first->node] = tip ? inwardNormal<Dim>(x, face.nodes) : mean;
            face.bent |= (face.normal[first->node] - inwardNormal<Dim>(x, face.nodes)).norm() > 1e-9;
        }
    }
}

/// Nearest point of a face, and whether it lies on the edge opposite to a node and the point beyond it; else -1.
std::pair<Vec<2>, int> nearestOn(const Points<2>& x, const Face<2>& face, const Vec<2>& point) {
    const Vec<2>& a = x[face[0]];
    const Vec<2> t = x[face[1]] - a;
    const double s = (point - a).dot(t) / t.squaredNorm();
    if (s < 0) return {a, 1};
    if (s > 1) return {x[face[1]], 0};
    return {a + s * t, -1};
}

std::pair<Vec<3>, int> nearestOn(const Points<3>& x, const Face<3>& face, const Vec<3>& point) {
    const Vec<3> n = faceArea<3>(x, face).normalized(), foot = point - n * n.dot(point - x[face[0]]);
    Vec<3> nearest = foot;
    int beyond = -1;
    double best = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec<3>&a = x[face[(k + 1) % 3]], &b = x[face[(k + 2) % 3]];
        if (n.dot((b - a).cross(foot - a)) >= 0) continue;
        const double w = nearestWeight<3>(a, b, foot);
        const Vec<3> onEdge = a + w * (b - a);
        if (beyond >= 0 && (onEdge - foot).norm() >= best) continue;
        best = (onEdge - foot).norm();
        nearest = onEdge;
        beyond = k;
    }
    return {nearest, beyond};
}

}  // namespace

template <int Dim>
Vec<Dim> inwardNormal(const Points<Dim>& x, const Face<Dim>& face) {
    return -faceArea<Dim>(x, face).normalized();
}

template <int Dim>
std::vector<WallFace<Dim>> wallFaces(const std::vector<Patch<Dim>>& patches, const std::vector<bool>& isWall,
                                     const Points<Dim>& x) {
    std::vector<WallFace<Dim>> walls;
    for (std::size_t k = 0; k < patches.size(); ++k)
        for (const auto& nodes : patches[k].faces) {
            WallFace<Dim> face{nodes, isWall[k] ? static_cast<int>(k) : -1};
            face.next.fill(-1);
            face.normal.fill(Vec<Dim>::Zero());
            walls.push_back(face);
        }
    std::vector<int> parent(walls.size());
    std::iota(parent.begin(), parent.end(), 0);
    joinFaces<Dim>(x, walls, parent);
    setNormals<Dim>(x, parent, walls);
    int nRegions = 0;
    for (std::size_t w = 0; w < walls.size(); ++w) {
        if (walls[w].patch < 0) continue;
        const int first = root(parent, static_cast<int>(w));
        walls[w].region = first == static_cast<int>(w) ? nRegions++ : walls[first].region;
    }
    return walls;
}

template <int Dim>
std::vector<std::pair<int, int>> convexPairs(const std::vector<WallFace<Dim>>& walls) {
    std::vector<std::pair<int, int>> pairs;
    for (const auto& face : walls)
        for (int k = 0; face.patch >= 0 && k < Dim; ++k)
            if (face.bend[k] == Bend::convex) pairs.emplace_back(face.region, walls[face.next[k]].region);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

namespace {

/// a -> b with the normals there: x(s) = Hermite's cubic with the tangents T_k = d - n_k (n_k . d), d = b - a.
struct Curve {
    Vec<2> a, d, Ta, Tb;

    Vec<2> at(double s) const {
        return a + s * s * (3 - 2 * s) * d + s * (1 - s) * (1 - s) * Ta - s * s * (1 - s) * Tb;
    }
    Vec<2> slope(double s) const { return 6 * s * (1 - s) * d + (1 - s) * (1 - 3 * s) * Ta + s * (3 * s - 2) * Tb; }
};

/// The point of the curved face nearest to the one that is nearest on the straight face. 3D: x = sum w_i (f - n_i n_i .
/// (f - x_i)/2) over the foot f = sum w_i x_i, the parabola between two nodes.
template <int Dim>
void bend(const WallFace<Dim>& face, const Points<Dim>& x, const Vec<Dim>& point, WallPlace<Dim>& place) {
    place.normal = inwardNormal<Dim>(x, face.nodes);
    if constexpr (Dim == 2) {
        if (!face.bent) return;
        const Vec<2>& a = x[face.nodes[0]];
        const Vec<2> d = x[face.nodes[1]] - a;
        const auto tangent = [&](const Vec<2>& n) { return Vec<2>(d - n * n.dot(d)); };
        const Curve curve{a, d, tangent(face.normal[0]), tangent(face.normal[1])};
        double s = std::clamp(d.dot(point - a) / d.squaredNorm(), 0.0, 1.0);
        for (int k = 0; k < 4; ++k)  // (point - x(s)) . x'(s) = 0
            s = std::clamp(s + curve.slope(s).dot(point - curve.at(s)) / curve.slope(s).squaredNorm(), 0.0, 1.0);
        place.x = curve.at(s);
        const Vec<2> t = curve.slope(s).normalized();
        place.normal = {-t[1], t[0]};
    } else if (face.bent) {
        const Vec<3> flat = place.x;
        Vec<3> q = flat;
        for (int k = 0; k < 5; ++k) {  // the place over whose foot the point is
            const Vec<3> positive = footWeights<3>(x, face.nodes, q).cwiseMax(0.0), w = positive / positive.sum();
            Vec<3> foot = Vec<3>::Zero(), off = Vec<3>::Zero();
            place.normal.setZero();
            for (int i = 0; i < 3; ++i) foot += w[i] * x[face.nodes[i]];
            for (int i = 0; i < 3; ++i) {
                off -= 0.5 * w[i] * face.normal[i] * face.normal[i].dot(foot - x[face.nodes[i]]);
                place.normal += w[i] * face.normal[i];
            }
            place.normal.normalize();
            place.x = foot + off;
            const Vec<3> n = inwardNormal<3>(x, face.nodes);
            q = flat - (off - n * n.dot(off));
        }
    }
}

/// Of the faces round a point of a region, in the order in which smooth edges lead from one to the next, the first that
/// is nearer to `point` than `distance` squared, else -1. Round a tip all of them are equally far from what is beyond
/// it.
int nearerRound(const std::vector<WallFace<3>>& walls, const Points<3>& x, int face, int tip, const Vec<3>& point,
                double distance) {
    int before = -1, current = face;
    for (std::size_t turn = 0; turn < walls.size(); ++turn) {
        int next = -1;
        for (int k = 0; k < 3 && next < 0; ++k)  // over an edge of the tip, but not back
            if (walls[current].nodes[k] != tip && walls[current].bend[k] == Bend::smooth &&
                walls[current].next[k] != before)
                next = walls[current].next[k];
        if (next < 0 || next == face) return -1;
        if ((point - nearestOn(x, walls[next].nodes, point).first).squaredNorm() < distance * (1 - 1e-12)) return next;
        before = current;
        current = next;
    }
    return -1;
}

/// The point of a face that `place` is, -1: none.
int pointAt(const Points<3>& x, const Face<3>& face, const Vec<3>& place) {
    const double size = (x[face[1]] - x[face[0]]).squaredNorm();
    const auto at = std::find_if(face.begin(), face.end(),
                                 [&](int node) { return (x[node] - place).squaredNorm() < 1e-24 * size; });
    return at == face.end() ? -1 : *at;
}

}  // namespace

template <int Dim>
WallPlace<Dim> placeOnRegion(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x, int face,
                             const Vec<Dim>& point) {
    auto [nearest, beyond] = nearestOn(x, walls[face].nodes, point);
    double distance = (point - nearest).squaredNorm();
    for (bool better = true; better;) {
        better = false;
        for (int k = 0; k < Dim; ++k) {
            if (walls[face].bend[k] != Bend::smooth) continue;
            const int other = walls[face].next[k];
            const auto [place, past] = nearestOn(x, walls[other].nodes, point);
            const double d = (point - place).squaredNorm();
            if (!(d < distance * (1 - 1e-12))) continue;
            face = other, nearest = place, beyond = past, distance = d;
            better = true;
            break;
        }
        if constexpr (Dim == 3) {
            const int tip = better ? -1 : pointAt(x, walls[face].nodes, nearest);
            const int other = tip < 0 ? -1 : nearerRound(walls, x, face, tip, point, distance);
            if (other < 0) continue;
            face = other, better = true;
            std::tie(nearest, beyond) = nearestOn(x, walls[face].nodes, point);
            distance = (point - nearest).squaredNorm();
        }
    }
    const bool ends = beyond >= 0 && walls[face].bend[beyond] != Bend::smooth;
    WallPlace<Dim> place{face, nearest, {}, ends ? beyond : -1};
    bend<Dim>(walls[face], x, point, place);
    return place;
}

#define PFEM_INSTANTIATE(D)                                                                                \
    template Vec<D> inwardNormal<D>(const Points<D>&, const Face<D>&);                                     \
    template std::vector<WallFace<D>> wallFaces<D>(const std::vector<Patch<D>>&, const std::vector<bool>&, \
                                                   const Points<D>&);                                      \
    template std::vector<std::pair<int, int>> convexPairs<D>(const std::vector<WallFace<D>>&);             \
    template WallPlace<D> placeOnRegion<D>(const std::vector<WallFace<D>>&, const Points<D>&, int, const Vec<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
