#include "momentum/meniscus.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
std::array<double, Dim> meniscusPressure(const Vec<Dim>& weight, const Topology<Dim>& topology, const Points<Dim>& x,
                                         const std::vector<double>& h, const Face<Dim>& face) {
    std::array<double, Dim> p{};
    Vec<Dim> sum = Vec<Dim>::Zero();
    int free = 0;
    for (const int i : face) {
        if (topology.held(i)) continue;
        sum += x[i];
        ++free;
    }
    if (free == 0 || free == Dim) return p;
    for (int k = 0; k < Dim; ++k) {
        if (!topology.held(face[k])) continue;
        const double most = weight.norm() * h[face[k]];
        p[k] = std::clamp(weight.dot(x[face[k]] - sum / free), -most, most);
    }
    return p;
}

template <int Dim>
void addMeniscus(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                 const Points<Dim>& x, const std::vector<double>& h, Points<Dim>& force) {
    for (const auto& face : topology.faces) {
        if (face.kind != FaceKind::freeSurface) continue;
        const Vec<Dim> weight = problem.fluid(fluid.material[face.cell]).rho * problem.gravity;
        const auto p = meniscusPressure<Dim>(weight, topology, x, h, face.nodes);
        for (int k = 0; k < Dim; ++k) {
            if (p[k] == 0) continue;
            const Vec<Dim> share = p[k] / (Dim * (Dim + 1)) * faceArea<Dim>(x, face.nodes);
            for (const int free : face.nodes) {
                if (topology.held(free)) continue;
                force[free] -= share;
                force[face.nodes[k]] += share;
            }
        }
    }
}

template <int Dim>
double meniscusWork(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                    const Nodes<Dim>& old, const Nodes<Dim>& now, double gamma) {
    Points<Dim> middle(old.x.size()), force(old.x.size(), Vec<Dim>::Zero());
    forEach(old.size(), [&](int i) { middle[i] = (1 - gamma) * old.x[i] + gamma * now.x[i]; });
    addMeniscus<Dim>(problem, fluid, topology, middle, old.h, force);
    return sumOver(old.size(), [&](int i) { return force[i].dot(now.x[i] - old.x[i]); });
}

template std::array<double, 2> meniscusPressure<2>(const Vec<2>&, const Topology<2>&, const Points<2>&,
                                                   const std::vector<double>&, const Face<2>&);
template void addMeniscus<2>(const Problem<2>&, const Cells<2>&, const Topology<2>&, const Points<2>&,
                             const std::vector<double>&, Points<2>&);
template double meniscusWork<2>(const Problem<2>&, const Cells<2>&, const Topology<2>&, const Nodes<2>&,
                                const Nodes<2>&, double);

}  // namespace pfem
