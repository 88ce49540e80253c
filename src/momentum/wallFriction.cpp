#include "momentum/wallFriction.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
Vec<Dim> slidingVelocity(const Problem<Dim>& problem, int patch, const Vec<Dim>& n, const Vec<Dim>& x,
                         const Vec<Dim>& v) {
    Vec<Dim> u = v;
    const auto& motion = problem.conditions.motion[patch];
    if (motion) u -= motion->template step<Dim>(problem.time, problem.time).velocityAt(x);
    return u - n * n.dot(u);
}

template <int Dim>
Vec<Dim> wallFriction(const Problem<Dim>& problem, int patch, double rho, const Vec<Dim>& u) {
    return -0.5 * rho * problem.conditions.friction[patch] * u.norm() * u;
}

template <int Dim>
void addWallFriction(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                     const Nodes<Dim>& nodes, Points<Dim>& force) {
    const auto& conditions = problem.conditions;
    if (std::all_of(conditions.friction.begin(), conditions.friction.end(), [](double c) { return c == 0; })) return;
    for (const auto& face : topology.faces) {
        if (face.wall < 0) continue;
        const int patch = topology.walls[face.wall].patch;
        const Vec<Dim> area = faceArea<Dim>(nodes.x, face.nodes);
        const double measure = area.norm(), rho = problem.fluid(fluid.material[face.cell]).rho;
        if (conditions.friction[patch] == 0 || measure == 0) continue;
        for (int node : face.nodes) {
            const auto* ride = topology.rideOn(node, face.wall);
            const Vec<Dim> v = ride ? Vec<Dim>(nodes.v[node] - ride->under(nodes.v)) : nodes.v[node];
            const Vec<Dim> u = slidingVelocity<Dim>(problem, patch, area / measure, nodes.x[node], v);
            const Vec<Dim> friction = measure / Dim * wallFriction<Dim>(problem, patch, rho, u);
            force[node] += friction;
            if (ride) ride->spread(-friction, force);
        }
    }
}

template <int Dim>
Vec<Dim> sideFriction(const Problem<Dim>& problem, double rho, const Vec<Dim>& v) {
    return -rho * problem.conditions.sideFriction * v.norm() * v;
}

template <int Dim>
void addSideFriction(const Problem<Dim>& problem, const Cells<Dim>& fluid, const SmoothingDomains<Dim>& domains,
                     const Points<Dim>& v, Points<Dim>& force) {
    if (problem.conditions.sideFriction == 0) return;
    const NodeToCells& around = *domains.around;
    domains.share.forNodes(domains.nNodes(), [&](int i) {
        if (around.count(i) == 0) return;
        const double rho = problem.fluid(fluid.material[around.cell[around.start[i]]]).rho;
        force[i] += domains.volume[i] * sideFriction<Dim>(problem, rho, v[i] + problem.frameVelocity);
    });
}

template <int Dim>
void addDamping(const Problem<Dim>& problem, const Cells<Dim>& fluid, const SmoothingDomains<Dim>& domains,
                const Nodes<Dim>& nodes, Points<Dim>& force) {
    const NodeToCells& around = *domains.around;
    const Vec<Dim>& frame = problem.frameVelocity;
    for (const auto& zone : problem.conditions.damping)
        domains.share.forNodes(domains.nNodes(), [&](int i) {
            if (around.count(i) == 0) return;
            const double rho = problem.fluid(fluid.material[around.cell[around.start[i]]]).rho;
            force[i] -= domains.volume[i] * rho * zone.at(nodes.x[i]) * (nodes.v[i] + frame - zone.velocity);
        });
}

#define PFEM_INSTANTIATE(D)                                                                                            \
    template Vec<D> sideFriction<D>(const Problem<D>&, double, const Vec<D>&);                                         \
    template void addSideFriction<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&, const Points<D>&, \
                                     Points<D>&);                                                                      \
    template void addDamping<D>(const Problem<D>&, const Cells<D>&, const SmoothingDomains<D>&, const Nodes<D>&,       \
                                Points<D>&);                                                                           \
    template Vec<D> slidingVelocity<D>(const Problem<D>&, int, const Vec<D>&, const Vec<D>&, const Vec<D>&);           \
    template Vec<D> wallFriction<D>(const Problem<D>&, int, double, const Vec<D>&);                                    \
    template void addWallFriction<D>(const Problem<D>&, const Cells<D>&, const Topology<D>&, const Nodes<D>&,          \
                                     Points<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
