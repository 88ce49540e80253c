#include "momentum/meniscus.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "state/calm.hpp"

namespace pfem {

namespace {

/// 1 - v^2/(g h/10) of the face's fastest node, no less than 0.
template <int Dim>
double calmness(double g, const Nodes<Dim>& nodes, const Face<Dim>& face) {
    double least = 1;
    for (const int i : face) least = std::min(least, 1 - nodes.v[i].squaredNorm() / calmSpeedSquared(g, nodes.h[i]));
    return std::max(0.0, least);
}

}  // namespace

template <int Dim>
std::array<double, Dim> meniscusPressure(const Problem<Dim>& problem, double rho, const Topology<Dim>& topology,
                                         const Nodes<Dim>& nodes, const Face<Dim>& face) {
    std::array<double, Dim> p{};
    Vec<Dim> sum = Vec<Dim>::Zero();
    int free = 0;
    for (const int i : face) {
        if (topology.onSolid[i]) continue;
        sum += nodes.x[i];
        ++free;
    }
    const double g = problem.gravity.norm();
    if (free == 0 || free == Dim || g == 0) return p;
    const double calm = calmness<Dim>(g, nodes, face);
    for (int k = 0; k < Dim; ++k) {
        const int i = face[k];
        if (!topology.onSolid[i]) continue;
        const double most = rho * g * nodes.h[i];
        p[k] = calm * std::clamp(rho * problem.gravity.dot(nodes.x[i] - sum / free), -most, most);
    }
    return p;
}

template <int Dim>
void addMeniscus(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                 const Nodes<Dim>& nodes, Points<Dim>& force) {
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const double rho = problem.fluid(fluid.material[face.cell]).rho;
        const auto p = meniscusPressure<Dim>(problem, rho, topology, nodes, face.nodes);
        for (int k = 0; k < Dim; ++k) {
            if (p[k] == 0) continue;
            const Vec<Dim> share = p[k] / (Dim * (Dim + 1)) * faceArea<Dim>(nodes.x, face.nodes);
            for (const int free : face.nodes) {
                if (topology.onSolid[free]) continue;
                force[free] -= share;
                force[face.nodes[k]] += share;
            }
        }
    }
}

template <int Dim>
double meniscusWork(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                    const Nodes<Dim>& old, const Nodes<Dim>& now, double gamma) {
    Nodes<Dim> middle;  // of what addMeniscus asks for
    middle.x.resize(old.x.size());
    middle.v.resize(old.v.size());
    middle.h = old.h;
    Points<Dim> force(old.x.size(), Vec<Dim>::Zero());
    parallelFor(old.size(), [&](int i) {
        middle.x[i] = (1 - gamma) * old.x[i] + gamma * now.x[i];
        middle.v[i] = (1 - gamma) * old.v[i] + gamma * now.v[i];
    });
    addMeniscus<Dim>(problem, fluid, topology, middle, force);
    return parallelSum(old.size(), [&](int i) { return force[i].dot(now.x[i] - old.x[i]); });
}

#define PFEM_INSTANTIATE(D)                                                                                            \
    template std::array<double, D> meniscusPressure<D>(const Problem<D>&, double, const Topology<D>&, const Nodes<D>&, \
                                                       const Face<D>&);                                                \
    template void addMeniscus<D>(const Problem<D>&, const Cells<D>&, const Topology<D>&, const Nodes<D>&, Points<D>&); \
    template double meniscusWork<D>(const Problem<D>&, const Cells<D>&, const Topology<D>&, const Nodes<D>&,           \
                                    const Nodes<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
