#include "remesh/movedMesh.hpp"

#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
MovedMesh<Dim> movedMesh(const State<Dim>& state, Topology<Dim> topology, const std::vector<int>& gone) {
    MovedMesh<Dim> moved;
    moved.x = state.nodes.x;
    moved.dropVolume = state.nodes.dropVolume;
    moved.lostVolume = state.nodes.lostVolume;
    moved.gone.assign(moved.x.size(), 0.0);
    for (const int drop : gone) std::swap(moved.gone[drop], moved.dropVolume[drop]);
    moved.fluid = state.mesh.fluid.nodes;
    moved.solid = state.mesh.solid.nodes;
    moved.topology = std::move(topology);
    moved.volume = cellVolume<Dim>(moved.x, moved.fluid);
    return moved;
}

template MovedMesh<2> movedMesh<2>(const State<2>&, Topology<2>, const std::vector<int>&);

}  // namespace pfem
