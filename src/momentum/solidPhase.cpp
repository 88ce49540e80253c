#include "momentum/solidPhase.hpp"

#include "momentum/mass.hpp"

namespace pfem {

template <int Dim>
SolidPhase<Dim>::SolidPhase(const Problem<Dim>& ofProblem, const SolidControls& withControls, const Mesh<Dim>& mesh,
                            const NodeToCells& around, const Nodes<Dim>& nodes, Integration scheme)
    : problem(ofProblem),
      controls(withControls),
      cells(mesh.solid),
      patches(makePatches<Dim>(cells.nodes, around, nodes.x, scheme)),
      gradients(patches),
      mass(solidMass<Dim>(problem, cells, nodes.X)),
      elementStress(storedElementStress<Dim>(problem, controls, cells, patches, nodes)) {}

template <int Dim>
void SolidPhase<Dim>::moveTo(const Nodes<Dim>& old, const Nodes<Dim>& end, double dt) {
    updatePatches<Dim>(patches, end.x);
    updateGradientPatches<Dim>(problem, cells, old, end, gradients);
    stress = solidStress<Dim>(problem, controls, cells, gradients, old, end, dt);
    elementStress = solidElementStress<Dim>(problem, controls, cells, gradients, patches, stress, end);
}

template struct SolidPhase<2>;

}  // namespace pfem
