#include "momentum/residual.hpp"

#include "base/parallel.hpp"
#include "momentum/bentWalls.hpp"
#include "momentum/mass.hpp"
#include "momentum/meniscus.hpp"
#include "momentum/outletPressure.hpp"
#include "momentum/wallFriction.hpp"

namespace pfem {

template <int Dim>
std::vector<double> nodalMass(const FluidPhase<Dim>& fluid, const SolidPhase<Dim>& solid) {
    auto mass = fluidMass<Dim>(fluid.problem, fluid.cells, fluid.domains);
    parallelFor(static_cast<int>(mass.size()), [&](int i) { mass[i] += solid.mass[i]; });
    return mass;
}

template <int Dim>
Points<Dim> tractionForce(const Mesh<Dim>& mesh, const BoundaryConditions<Dim>& conditions, const Points<Dim>& x) {
    Points<Dim> force(x.size(), Vec<Dim>::Zero());
    for (std::size_t n = 0; n < mesh.patches.size(); ++n) {
        if (!conditions.type[n]->loads) continue;
        for (const auto& face : mesh.patches[n].faces)
            for (int node : face) force[node] += conditions.traction[n] * (faceArea<Dim>(x, face).norm() / Dim);
    }
    return force;
}

template <int Dim>
Points<Dim> externalForce(const Mesh<Dim>& mesh, const Topology<Dim>& topology, const FluidPhase<Dim>& fluid,
                          const Nodes<Dim>& nodes) {
    auto force = tractionForce<Dim>(mesh, fluid.problem.conditions, nodes.x);
    addChordPressure<Dim>(topology, nodes, force);
    addMeniscus<Dim>(fluid.problem, mesh.fluid, topology, nodes, force);
    addOutletPressure<Dim>(fluid.problem, mesh.fluid, topology, nodes, force);
    addWallFriction<Dim>(fluid.problem, mesh.fluid, topology, nodes, force);
    addSideFriction<Dim>(fluid.problem, mesh.fluid, fluid.domains, nodes.v, force);
    addDamping<Dim>(fluid.problem, mesh.fluid, fluid.domains, nodes, force);
    return force;
}

template <int Dim>
Points<Dim> viscousForces(const FluidPhase<Dim>& fluid, double waveDamping, const Nodes<Dim>& nodes) {
    const auto L = velocityGradients<Dim>(fluid.domains, nodes.v);
    auto force = viscousForce<Dim>(fluid.domains, fluid.viscosity.mu, L);
    const auto zigzag = zigzagForce<Dim>(fluid.problem, fluid.cells, fluid.domains, waveDamping, nodes.h, L);
    fluid.domains.share.forNodes(nodes.size(), [&](int i) { force[i] += zigzag[i]; });
    return force;
}

template <int Dim>
Points<Dim> momentumResidual(const std::vector<double>& mass, const Nodes<Dim>& nodes, const FluidPhase<Dim>& fluid,
                             const SolidPhase<Dim>& solid, const Points<Dim>& external, double share) {
    const Vec<Dim>& gravity = fluid.problem.gravity;
    Points<Dim> R(nodes.size());
    fluid.domains.share.forNodes(nodes.size(), [&](int i) { R[i] = mass[i] * (nodes.a[i] - gravity) - external[i]; });
    addPressureForce<Dim>(fluid.domains, nodes.p, R);
    auto stress = solid.elementStress;
    for (auto& sigma : stress) sigma *= share;
    addInternalForce<Dim>(solid.domains, stress, R);
    return R;
}

#define PFEM_INSTANTIATE(D)                                                                                         \
    template std::vector<double> nodalMass<D>(const FluidPhase<D>&, const SolidPhase<D>&);                          \
    template Points<D> tractionForce<D>(const Mesh<D>&, const BoundaryConditions<D>&, const Points<D>&);            \
    template Points<D> externalForce<D>(const Mesh<D>&, const Topology<D>&, const FluidPhase<D>&, const Nodes<D>&); \
    template Points<D> viscousForces<D>(const FluidPhase<D>&, double, const Nodes<D>&);                             \
    template Points<D> momentumResidual<D>(const std::vector<double>&, const Nodes<D>&, const FluidPhase<D>&,       \
                                           const SolidPhase<D>&, const Points<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
