#include "momentum/solidPhase.hpp"

#include "momentum/mass.hpp"
#include "momentum/pointMotion.hpp"

namespace pfem {

template <int Dim>
SolidPhase<Dim>::SolidPhase(const Problem<Dim>& problem, const SolidControls& controls, const Mesh<Dim>& mesh,
                            const NodeToCells& around, const Nodes<Dim>& nodes, Integration scheme)
    : solids{problem, controls, mesh.solid},
      domains(makeSmoothingDomains<Dim>(mesh.solid.nodes, around, nodes.x, scheme)),
      gradients(domains),
      mass(solidMass<Dim>(problem, mesh.solid, nodes.X)),
      elementStress(storedElementStress<Dim>(solids, domains, nodes)) {}

template <int Dim>
void SolidPhase<Dim>::moveTo(const Nodes<Dim>& old, const Nodes<Dim>& end, double dt) {
    if (domains.nCells() == 0) return;
    updateSmoothingDomains<Dim>(domains, end.x);
    updateGradientDomains<Dim>(solids.problem, solids.cells, old, end, gradients);
    stress = solidStress<Dim>(solids, gradients, old, end, dt);
    elementStress = solidElementStress<Dim>(solids, gradients, domains, stress, end);
}

#define PFEM_INSTANTIATE(D) template struct SolidPhase<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
