#include "momentum/consistentMass.hpp"

namespace pfem {

namespace {

template <int Dim>
Vec<Dim> sumOver(const Simplex<Dim>& cell, const Points<Dim>& u) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const int i : cell) sum += u[i];
    return sum;
}

}  // namespace

template <int Dim>
void addMassDifference(const FluidPhase<Dim>& fluid, double factor, const Points<Dim>& u, Points<Dim>& y) {
    const NodeToCells& around = *fluid.domains.around;
    fluid.domains.share.forNodes(fluid.domains.nNodes(), [&](int i) {
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const int e = around.cell[s];
            const double mass = fluid.problem.fluid(fluid.cells.material[e]).rho * fluid.domains.element[e].measure;
            y[i] +=
                factor * mass / ((Dim + 1) * (Dim + 2)) * (sumOver<Dim>(fluid.cells.nodes[e], u) - (Dim + 1) * u[i]);
        }
    });
}

template <int Dim>
double squaredSpeedDifference(const Simplex<Dim>& cell, const Points<Dim>& v) {
    double squares = 0;
    for (const int i : cell) squares += v[i].squaredNorm();
    return (sumOver<Dim>(cell, v).squaredNorm() - (Dim + 1) * squares) / (Dim + 2);
}

#define PFEM_INSTANTIATE(D)                                                                         \
    template void addMassDifference<D>(const FluidPhase<D>&, double, const Points<D>&, Points<D>&); \
    template double squaredSpeedDifference<D>(const Simplex<D>&, const Points<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
