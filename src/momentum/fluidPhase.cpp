#include "momentum/fluidPhase.hpp"

namespace pfem {

template <int Dim>
FluidPhase<Dim>::FluidPhase(const Problem<Dim>& ofProblem, const Mesh<Dim>& mesh, const NodeToCells& around,
                            const Nodes<Dim>& nodes, Integration scheme, const Share& share)
    : problem(ofProblem),
      cells(mesh.fluid),
      pressure(nodes.p),
      domains(makeSmoothingDomains<Dim>(mesh.fluid.nodes, around, nodes.x, scheme, share)),
      newtonian(isNewtonian<Dim>(problem)),
      viscosity(flowViscosity<Dim>(problem, cells, domains, nodes.v, nodes.p)),
      mu(fromPoints<Dim>(domains, viscosity.mu)) {}

template <int Dim>
void FluidPhase<Dim>::moveTo(const Points<Dim>& x) {
    follows = waiting == 0;
    if (follows)
        updateSmoothingDomains<Dim>(domains, x);
    else
        --waiting;
}

template <int Dim>
FluidPhase<Dim> FluidPhase<Dim>::whole(const Points<Dim>& x) const {
    FluidPhase<Dim> all = *this;
    if (domains.share.isWhole()) return all;
    all.divide({});
    if (follows) updateSmoothingDomains<Dim>(all.domains, x);
    if (newtonian) return all;
    auto viscosities = std::move(all.viscosity.mu).values();
    domains.share.gather(viscosities);
    all.viscosity.mu = PerPoint<double>(std::move(viscosities));
    all.mu = fromPoints<Dim>(all.domains, all.viscosity.mu);
    return all;
}

template <int Dim>
void FluidPhase<Dim>::flow(const Points<Dim>& v) {
    if (newtonian) return;
    viscosity = flowViscosity<Dim>(problem, cells, domains, v, pressure);
    mu = fromPoints<Dim>(domains, viscosity.mu);
}

template <int Dim>
PerCell<double> FluidPhase<Dim>::tangent() const {
    return newtonian ? mu : fromPoints<Dim>(domains, tangentViscosity<Dim>(viscosity));
}

#define PFEM_INSTANTIATE(D) template struct FluidPhase<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
