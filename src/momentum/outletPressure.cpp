#include "momentum/outletPressure.hpp"

#include <algorithm>

#include "mesh/simplex.hpp"

namespace pfem {

namespace {

/// The outlet that a face of the fluid is on; null: none.
template <int Dim>
const Outlet* outletAt(const Problem<Dim>& problem, const Topology<Dim>& topology, const FluidFace<Dim>& face) {
    return face.wall < 0 ? nullptr : problem.conditions.outlet[topology.walls[face.wall].patch].get();
}

}  // namespace

template <int Dim>
double outsidePressure(const Problem<Dim>& problem, const Outlet& outlet, double rho, const Vec<Dim>& x,
                       double outflow) {
    if (outlet.pressure) return outlet.pressure->value(problem.time);
    if (!outlet.level) return 0;
    const Vec<Dim> g = problem.gravityOutside();
    return std::max(0.0,
                    rho * (g.norm() * outlet.level->value(problem.time) + g.dot(x)) + rho * outlet.waveSpeed * outflow);
}

template <int Dim>
void addOutletPressure(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                       const Nodes<Dim>& nodes, Points<Dim>& force) {
    if (!problem.conditions.anyOutlet()) return;
    for (const auto& face : topology.faces) {
        const Outlet* outlet = outletAt<Dim>(problem, topology, face);
        if (!outlet || !(outlet->pressure || outlet->level)) continue;
        const Vec<Dim> area = faceArea<Dim>(nodes.x, face.nodes);  // out of the fluid
        const Vec<Dim> n = outlet->waveSpeed > 0 ? area.normalized() : Vec<Dim>(Vec<Dim>::Zero());
        const double rho = problem.fluid(fluid.material[face.cell]).rho;
        for (int J = 0; J < Dim; ++J)
            for (const int i : face.nodes)  // int_f N_I N_J dS = |f| (1 + delta_IJ)/(Dim (Dim + 1))
                force[face.nodes[J]] -=
                    (i == face.nodes[J] ? 2.0 : 1.0) / (Dim * (Dim + 1)) *
                    outsidePressure<Dim>(problem, *outlet, rho, nodes.x[i], n.dot(nodes.v[i] + problem.frameVelocity)) *
                    area;
    }
}

template <int Dim>
void addOutletStiffness(const Problem<Dim>& problem, const Cells<Dim>& fluid, const Topology<Dim>& topology,
                        const Points<Dim>& x, Points<Dim>& stiffness) {
    if (!problem.conditions.anyOutlet()) return;
    for (const auto& face : topology.faces) {
        const Outlet* outlet = outletAt<Dim>(problem, topology, face);
        if (!outlet || outlet->waveSpeed == 0) continue;
        const Vec<Dim> area = faceArea<Dim>(x, face.nodes);
        const double share = problem.fluid(fluid.material[face.cell]).rho * outlet->waveSpeed / Dim;
        if (area.norm() > 0)
            for (const int node : face.nodes) stiffness[node] += share * area.cwiseAbs2() / area.norm();
    }
}

#define PFEM_INSTANTIATE(D)                                                                                       \
    template double outsidePressure<D>(const Problem<D>&, const Outlet&, double, const Vec<D>&, double);          \
    template void addOutletPressure<D>(const Problem<D>&, const Cells<D>&, const Topology<D>&, const Nodes<D>&,   \
                                       Points<D>&);                                                               \
    template void addOutletStiffness<D>(const Problem<D>&, const Cells<D>&, const Topology<D>&, const Points<D>&, \
                                        Points<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
