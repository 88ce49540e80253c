#include "conditions/givingWay.hpp"

#include <algorithm>
#include <limits>
#include <optional>

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

/// Faces of the fluid on a patch; of periodic ones each once.
template <int Dim>
std::vector<Face<Dim>> wetPart(const Topology<Dim>& topology, const std::vector<Id>& id, int patch) {
    std::vector<Face<Dim>> wet;
    for (const auto& face : topology.faces)
        if (face.wall >= 0 && topology.walls[face.wall].patch == patch && isOwn(id, face.nodes))
            wet.push_back(face.nodes);
    return wet;
}

/// Height of the surface over the lowest node after a time [m]; nothing where it is dry.
template <int Dim>
std::optional<double> heightAfter(double after, const std::vector<Face<Dim>>& wet, const Nodes<Dim>& nodes,
                                  const Vec<Dim>& up) {
    double low = std::numeric_limits<double>::max(), area = 0, moment = 0;
    for (const auto& face : wet) {
        Points<Dim> later;
        Face<Dim> all{};
        double z = 0;
        for (int k = 0; k < Dim; ++k) {
            all[k] = k;
            later.push_back(nodes.x[face[k]] + after * nodes.v[face[k]]);
            low = std::min(low, up.dot(later.back()));
            z += up.dot(later.back()) / Dim;
        }
        const double a = faceArea<Dim>(later, all).norm();
        area += a;
        moment += a * z;
    }
    if (!(area > 0)) return std::nullopt;
    return 2 * (moment / area - low);
}

/// (x, y, z), in the plane (x, y, 0).
template <int Dim>
Eigen::Vector3d inSpace(const Vec<Dim>& x) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    result.head<Dim>() = x;
    return result;
}

}  // namespace

template <int Dim>
Vec<Dim> levelNormal(const std::vector<Face<Dim>>& faces, const Points<Dim>& x, const Vec<Dim>& up) {
    Vec<Dim> sum = Vec<Dim>::Zero();  // of a wall's face the area points away from the fluid
    double all = 0;
    for (const auto& face : faces) {
        sum -= faceArea<Dim>(x, face);
        all += faceArea<Dim>(x, face).norm();
    }
    sum -= up * up.dot(sum);
    return sum.norm() > 0.5 * all ? Vec<Dim>(sum.normalized()) : Vec<Dim>(Vec<Dim>::Zero());
}

template <int Dim>
void giveWay(const BoundaryConditions<Dim>& conditions, const Topology<Dim>& topology, const Nodes<Dim>& nodes,
             double t0, double t1, std::vector<RigidStep<Dim>>& motion) {
    for (int k = 0; k < static_cast<int>(conditions.motion.size()); ++k) {
        if (!conditions.motion[k] || !conditions.motion[k]->absorption()) continue;
        const WallMotion& prescribed = *conditions.motion[k];
        const Absorption& wall = *prescribed.absorption();
        const auto faces = facesOf<Dim>(topology, k);
        const Vec<Dim> up = wall.up.template head<Dim>(), into = levelNormal<Dim>(faces, nodes.x, up);
        const int first = faces.front()[0];  // all move alike
        const double dt = t1 - t0, ahead = wall.ahead(dt),
                     way = into.dot(nodes.x[first] - nodes.X[first] - prescribed.way(t0).template head<Dim>());
        double U = into.dot(nodes.v[first] - prescribed.velocity(t0).template head<Dim>());
        if (!(t0 > 0)) U = 0;  // what is prescribed may begin at once, from nodes at rest
        const auto height = heightAfter<Dim>(ahead, wetPart<Dim>(topology, nodes.id, k), nodes, up);
        const double excess = height ? *height - wall.depth - wall.own(t0 + ahead, inSpace<Dim>(into)) : 0;
        const double next = wall.answer(U, way, excess, dt);
        motion[k].to += 0.5 * dt * (U + next) * into;
        motion[k].velocity += next * into;
    }
}

#define PFEM_INSTANTIATE(D)                                                                                     \
    template Vec<D> levelNormal<D>(const std::vector<Face<D>>&, const Points<D>&, const Vec<D>&);               \
    template void giveWay<D>(const BoundaryConditions<D>&, const Topology<D>&, const Nodes<D>&, double, double, \
                             std::vector<RigidStep<D>>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
