#include "mesh/skinPoints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/nearestOnFace.hpp"

namespace pfem {

namespace {

template <int Dim>
SkinPoint<Dim> pointOn(const Topology<Dim>& topology, const Points<Dim>& x, const FluidFace<Dim>& face, int wall,
                       const Vec<Dim>& onFluid) {
    const Face<Dim>& solid = topology.walls[wall].nodes;
    return {0, onFluid, {-1, wall, solid, nearestWeights<Dim>(x, solid, weighted<Dim>(x, face.nodes, onFluid))}};
}

/// The solid's faces from one wall face to another along the skin, both included; empty when there is no way.
std::vector<int> facesBetween(const Topology<2>& topology, int from, int to) {
    std::vector<int> faces{from};
    while (faces.back() != to) {
        const WallFace<2>& face = topology.walls[faces.back()];
        const int next = face.next[0];  // beyond its second node
        if (next < 0 || !topology.isSkin(next) || next == from) return {};
        faces.push_back(next);
    }
    return faces;
}

std::vector<SkinPoint<2>> pointsOn(const Topology<2>& topology, const Points<2>& x, const FluidFace<2>& face,
                                   const std::array<const Ride<2>*, 2>& rides) {
    std::vector<SkinPoint<2>> points;
    const Vec<2>& a = x[face.nodes[0]];
    const Vec<2> d = x[face.nodes[1]] - a;
    const double gauss = 0.5 / std::sqrt(3.0);
    double begin = 0;
    const auto faces = facesBetween(topology, rides[0]->wall, rides[1]->wall);
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const double atEnd = d.dot(x[topology.walls[faces[k]].nodes[1]] - a) / d.squaredNorm();
        const double end = k + 1 == faces.size() ? 1 : std::clamp(atEnd, begin, 1.0);
        for (const double place : {0.5 - gauss, 0.5 + gauss}) {
            const double s = begin + place * (end - begin);
            points.push_back(pointOn<2>(topology, x, face, faces[k], {1 - s, s}));
            points.back().part = 0.5 * (end - begin);
        }
        begin = end;
    }
    return points;
}

/// The solid's face that is nearest to a point, of the regions on which nodes of the fluid's face ride.
int nearestWall(const Topology<3>& topology, const Points<3>& x, const FluidFace<3>& face, const Vec<3>& point) {
    int nearest = -1;
    double least = std::numeric_limits<double>::max();
    for (const int node : face.nodes)
        for (const int wall : topology.supports[node]) {
            if (wall < 0 || !topology.isSkin(wall)) continue;
            const auto place = placeOnRegion<3>(topology.walls, x, wall, point);
            const double distance = (place.x - point).norm();
            if (distance >= least) continue;
            least = distance;
            nearest = place.face;
        }
    return nearest;
}

std::vector<SkinPoint<3>> pointsOn(const Topology<3>& topology, const Points<3>& x, const FluidFace<3>& face,
                                   const std::array<const Ride<3>*, 3>&) {
    std::vector<SkinPoint<3>> points;
    const auto add = [&](const std::array<Vec<3>, 3>& corners) {  // of a quarter
        for (int k = 0; k < 3; ++k) {
            const Vec<3> w = (corners[0] + corners[1] + corners[2]) / 6 + corners[k] / 2;
            const int wall = nearestWall(topology, x, face, weighted<3>(x, face.nodes, w));
            points.push_back(pointOn<3>(topology, x, face, wall, w));
            points.back().part = 1.0 / 12;
        }
    };
    std::array<Vec<3>, 3> middles;
    for (int k = 0; k < 3; ++k) middles[k] = 0.5 * (Vec<3>::Ones() - Vec<3>::Unit(k));  // of the edge opposite to k
    add(middles);
    for (int k = 0; k < 3; ++k) add({Vec<3>::Unit(k), middles[(k + 1) % 3], middles[(k + 2) % 3]});
    return points;
}

}  // namespace

template <int Dim>
std::vector<SkinPoint<Dim>> skinPoints(const Topology<Dim>& topology, const Points<Dim>& x,
                                       const FluidFace<Dim>& face) {
    std::array<const Ride<Dim>*, Dim> rides{};
    for (std::size_t k = 0; k < Dim; ++k) {
        rides[k] = topology.rideOn(face.nodes[k], face.wall);
        if (!rides[k]) return {};
    }
    return pointsOn(topology, x, face, rides);
}

#define PFEM_INSTANTIATE(D) \
    template std::vector<SkinPoint<D>> skinPoints<D>(const Topology<D>&, const Points<D>&, const FluidFace<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
