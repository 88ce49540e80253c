#include "conditions/givingWay.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/simplex.hpp"
#include "state/images.hpp"

namespace pfem {

namespace {

/// Those of a patch of walls.
template <int Dim>
std::vector<Face<Dim>> facesOf(const Topology<Dim>& topology, int patch) {
    std::vector<Face<Dim>> faces;
    for (const auto& wall : topology.walls)
        if (wall.patch == patch) faces.push_back(wall.nodes);
    return faces;
}

/// Faces of the fluid on a patch, between periodic sides.
template <int Dim>
std::vector<Face<Dim>> wetPart(const Topology<Dim>& topology, const std::vector<Id>& id, int patch) {
    std::vector<Face<Dim>> wet;
    for (const auto& face : topology.faces)
        if (face.wall >= 0 && topology.walls[face.wall].patch == patch && isOwn(id, face.nodes))
            wet.push_back(face.nodes);
    return wet;
}

/// From the wall into the water, level.
template <int Dim>
Vec<Dim> inward(const std::vector<Face<Dim>>& faces, const Points<Dim>& x, const Vec<Dim>& up) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const auto& face : faces) sum -= faceArea<Dim>(x, face);
    return (sum - up * up.dot(sum)).normalized();
}

/// Extent of the faces across `inward` and `up`; 2D: 1.
template <int Dim>
double widthOf(const std::vector<Face<Dim>>& faces, const Points<Dim>& x, const Vec<Dim>& inward, const Vec<Dim>& up) {
    if constexpr (Dim == 2) {
        return 1;
    } else {
        const Vec<3> across = up.cross(inward);
        double low = std::numeric_limits<double>::max(), high = -low;
        for (const auto& face : faces)
            for (const int node : face) {
                low = std::min(low, across.dot(x[node]));
                high = std::max(high, across.dot(x[node]));
            }
        return high - low;
    }
}

/// Height of the surface over the still level after a time [m]; dry: 0, the wall stays.
template <int Dim>
double surfaceAt(const std::vector<Face<Dim>>& wet, const Nodes<Dim>& nodes, const Vec<Dim>& inward, const Vec<Dim>& up,
                 double depth, double after) {
    if (wet.empty()) return 0;
    double area = 0;
    for (const auto& face : wet) {
        Points<Dim> later;
        Face<Dim> all{};
        for (int k = 0; k < Dim; ++k) {
            all[k] = k;
            later.push_back(nodes.x[face[k]] + after * nodes.v[face[k]]);
        }
        area -= inward.dot(faceArea<Dim>(later, all));
    }
    return area / widthOf<Dim>(wet, nodes.x, inward, up) - depth;
}

}  // namespace

template <int Dim>
void giveWay(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Nodes<Dim>& nodes,
             double t0, double t1, std::vector<RigidStep<Dim>>& motion) {
    for (int k = 0; k < static_cast<int>(conditions.motion.size()); ++k) {
        if (!conditions.motion[k] || !conditions.motion[k]->absorption()) continue;
        const WallMotion& prescribed = *conditions.motion[k];
        const Absorption& wall = *prescribed.absorption();
        const auto faces = facesOf<Dim>(topology, k);
        const Vec<Dim> up = wall.up.template head<Dim>().normalized(), into = inward<Dim>(faces, nodes.x, up);
        const int first = faces.front()[0];  // all move alike
        const double way = into.dot(nodes.x[first] - nodes.X[first] - prescribed.way(t0).template head<Dim>()),
                     U = into.dot(nodes.v[first] - prescribed.velocity(t0).template head<Dim>()), dt = t1 - t0,
                     eta = surfaceAt<Dim>(wetPart<Dim>(topology, nodes.id, k), nodes, into, up, wall.depth,
                                          wall.ahead(dt));
        const double next = wall.answer(U, way, eta, t0, dt);
        motion[k].to += 0.5 * dt * (U + next) * into;
        motion[k].velocity += next * into;
    }
}

template void giveWay<2>(const BoundaryConditions<2>&, const Topology<2>&, const Nodes<2>&, double, double,
                         std::vector<RigidStep<2>>&);
template void giveWay<3>(const BoundaryConditions<3>&, const Topology<3>&, const Nodes<3>&, double, double,
                         std::vector<RigidStep<3>>&);

}  // namespace pfem
