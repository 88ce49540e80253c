#include "momentum/outletPressure.hpp"

#include <algorithm>

#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
double outsidePressure(const Problem<Dim>& problem, const Outlet& outlet, double rho, const Vec<Dim>& x) {
    if (outlet.pressure) return outlet.pressure->value(problem.time);
    if (!outlet.level) return 0;
    const Vec<Dim>& g = problem.gravity;
    return std::max(0.0, rho * (g.norm() * outlet.level->value(problem.time) + g.dot(x)));
}

template <int Dim>
void addOutletPressure(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                       const Points<Dim>& x, Points<Dim>& force) {
    if (!problem.conditions.anyOutlet()) return;
    for (const auto& face : topology.faces) {
        if (face.wall < 0) continue;
        const auto& outlet = problem.conditions.outlet[topology.walls[face.wall].patch];
        if (!outlet || !outlet->guides()) continue;
        const Vec<Dim> area = faceArea<Dim>(x, face.nodes);  // out of the fluid
        const double rho = problem.fluid(fluid.material[face.cell]).rho;
        for (int J = 0; J < Dim; ++J)
            for (int I = 0; I < Dim; ++I)  // int_f N_I N_J dS = |f| (1 + delta_IJ)/(Dim (Dim + 1))
                force[face.nodes[J]] -= (I == J ? 2.0 : 1.0) / (Dim * (Dim + 1)) *
                                        outsidePressure<Dim>(problem, *outlet, rho, x[face.nodes[I]]) * area;
    }
}

#define PFEM_INSTANTIATE(D)                                                                                      \
    template double outsidePressure<D>(const Problem<D>&, const Outlet&, double, const Vec<D>&);                 \
    template void addOutletPressure<D>(const Problem<D>&, const Cells<D>&, const Topology<D>&, const Points<D>&, \
                                       Points<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
