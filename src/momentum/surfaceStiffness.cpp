#include "momentum/surfaceStiffness.hpp"

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "momentum/outletPressure.hpp"

namespace pfem {

template <int Dim>
Points<Dim> surfaceStiffness(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                             const Points<Dim>& x, const MidpointRule& midpoint) {
    Points<Dim> stiffness(x.size(), Vec<Dim>::Zero());
    const double g = problem.gravity.norm();
    if (g == 0) return stiffness;
    const Vec<Dim> direction = problem.gravity.cwiseAbs2() / (g * g);
    for (const auto& face : topology.faces) {
        if (face.kind == FaceKind::wall && (face.wall < 0 || !topology.isSkin(face.wall))) continue;
        const double pressing = -problem.gravity.dot(faceArea<Dim>(x, face.nodes));  // |face| times -g . n
        const double share =
            0.5 * midpoint.dt * problem.fluid(fluid.material[face.cell]).rho * std::max(0.0, pressing) / Dim;
        for (int node : face.nodes) stiffness[node] += share * direction;
    }
    addOutletStiffness<Dim>(problem, fluid, topology, x, stiffness);
    return stiffness;
}

template <int Dim>
Points<Dim> matrixInertia(const std::vector<double>& mass, const Points<Dim>& stiffness, const MidpointRule& midpoint) {
    Points<Dim> inertia(mass.size());
    parallelFor(static_cast<int>(mass.size()),
                [&](int i) { inertia[i] = matrixInertia<Dim>(mass[i], stiffness[i], midpoint); });
    return inertia;
}

#define PFEM_INSTANTIATE(D)                                                                                          \
    template Points<D> surfaceStiffness<D>(const Problem<D>&, const Cells<D>&, const Topology<D>&, const Points<D>&, \
                                           const MidpointRule&);                                                     \
    template Points<D> matrixInertia<D>(const std::vector<double>&, const Points<D>&, const MidpointRule&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
